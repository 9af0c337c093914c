// SPDX-License-Identifier: BSD-3-Clause
// Forward kinematics: where every part of the robot is, from its joint angles and the table.
//
// Frame: the torso's, agent axes x forward, y left, z up, origin at the torso centre. Every part's
// own frame has the same axes at zero pose and its origin at the part's centre. Metres, radians.
// The table in common/nao uses body axes (x right, y forward); body_to_agent() turns them.
#pragma once

#include <array>

#include "common/math/geometry.h"
#include "common/nao/model.h"

namespace k3d::agent::kinematics {

/// The same vector, from body axes (x right, y forward, z up) to agent axes.
inline Vec3 body_to_agent(const Vec3& v) {
    return {v.y(), -v.x(), v.z()};
}

struct PartPose {
    Vec3 position = Vec3::Zero();
    Mat3 rotation = Mat3::Identity();  ///< part axes -> torso axes

    Vec3 operator*(const Vec3& point) const { return position + rotation * point; }
};

/// By nao::index(Part); parts that the type lacks stay at the torso.
using PartPoses = std::array<PartPose, nao::kPartCount>;

PartPoses forward(const nao::Model& model, const nao::JointArray& joints);

}  // namespace k3d::agent::kinematics
