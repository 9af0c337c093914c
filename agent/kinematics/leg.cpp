// SPDX-License-Identifier: BSD-3-Clause
// The foot is taken as the base: ankle roll from where the hip lies beside the foot, knee from the
// triangle hip-knee-ankle, ankle pitch from its direction; what rotation is left is the hip's.
#include "agent/kinematics/leg.h"

#include <algorithm>
#include <cmath>

namespace k3d::agent::kinematics {

namespace {

using nao::JointId;

const nao::JointDef* joint_of(const nao::Model& model, JointId id) {
    for (const nao::JointDef& joint : model.joints) {
        if (joint.id == id) return &joint;
    }
    return nullptr;
}

/// Pitch joints turn about body x, which is minus agent y.
Mat3 pitched(double angle) {
    return about_y(-angle);
}

/// Angle of v in the sagittal plane, counted as pitch joints do, from straight up.
double pitch_of(const Vec3& v) {
    return std::atan2(-v.x(), v.z());
}

}  // namespace

Leg::Leg(const nao::Model& model, Side side)
    : foot_(side == Side::Right ? nao::Part::RFoot : nao::Part::LFoot) {
    const auto& ids = side == Side::Right ? kRightLeg : kLeftLeg;
    std::array<Vec3, 6> hinge;  // torso frame at zero pose
    const PartPoses zero = forward(model, {});
    for (std::size_t i = 0; i < ids.size(); ++i) {
        joints_[i] = joint_of(model, ids[i]);
        const nao::Part child = model.bodies[static_cast<std::size_t>(joints_[i]->child)].part;
        hinge[i] = zero[nao::index(child)] * body_to_agent(joints_[i]->anchor);
    }
    const Vec3 foot = zero[nao::index(foot_)].position;
    const auto foot_body = static_cast<std::size_t>(joints_[5]->child);
    const Vec3 sole(hinge[4].x(), hinge[4].y(), foot.z() - model.bodies[foot_body].size.z() / 2.0);
    const Vec3 yaw_pitch = body_to_agent(joints_[0]->axis);
    hip_ = hinge[2];
    hip_axis_ = std::atan2(yaw_pitch.z(), yaw_pitch.y());
    thigh_ = hinge[3] - hinge[2];
    shank_ = hinge[4] - hinge[3];
    ankle_ = hinge[5] - hinge[4];
    sole_ = sole - hinge[5];
    sole_in_foot_ = sole - foot;
}

SolePose Leg::zero_pose() const {
    SolePose pose;
    pose.position = hip_ + thigh_ + shank_ + ankle_ + sole_;
    return pose;
}

SolePose Leg::sole(const PartPoses& parts) const {
    const PartPose& foot = parts[nao::index(foot_)];
    return {foot * sole_in_foot_, foot.rotation};
}

bool Leg::solve(const SolePose& target, nao::JointArray& joints) const {
    bool exact = true;
    // The hip seen from the ankle roll axis, in the foot's frame.
    const Vec3 roll_axis = target * Vec3(-sole_);
    const Vec3 hip = target.rotation.transpose() * (hip_ - roll_axis);
    // The leg above that axis has no sideways offset, so roll turns the hip into its plane.
    const double roll = std::atan2(hip.y(), hip.z());
    const Vec3 in_plane = about_x(roll) * hip;

    const Vec3 reach = in_plane + ankle_;  // from the ankle pitch axis
    const double l1 = thigh_.norm();
    const double l2 = shank_.norm();
    const double shortest = std::abs(l1 - l2) + 1e-6;
    const double longest = l1 + l2 - 1e-9;
    double distance = reach.norm();
    if (distance < shortest || distance > longest) exact = false;
    distance = std::clamp(distance, shortest, longest);
    const double bend_cosine = (l1 * l1 + l2 * l2 - distance * distance) / (2.0 * l1 * l2);
    const double bend = kPi - std::acos(std::clamp(bend_cosine, -1.0, 1.0));
    // Thigh and shank are not parallel at zero pose; the knee joint counts from there.
    const double knee_zero = pitch_of(-thigh_) - pitch_of(-shank_);
    const double knee = knee_zero - bend;
    // Direction of the hip over the ankle if the ankle joint were 0, against the wanted one.
    const Vec3 folded = -shank_ + pitched(-knee) * Vec3(-thigh_);
    const double ankle_pitch = pitch_of(folded) - pitch_of(reach);

    const Mat3 thigh = target.rotation * about_x(-roll) * pitched(-ankle_pitch - knee);
    // thigh = Rot(yaw-pitch axis, q1) Rx(q2) Rpitch(q3); turned about x, the axis becomes z
    // (right leg) or -z (left leg).
    const double up = std::copysign(1.0, hip_axis_);
    const double to_z = up * kPi / 2.0 - hip_axis_;
    const Mat3 m = about_x(to_z) * thigh;
    const double b = std::asin(std::clamp(m(2, 1), -1.0, 1.0));
    const double c = std::atan2(-m(2, 0), m(2, 2));
    const double a = std::atan2(-m(0, 1), m(1, 1));

    const std::array<double, 6> solution{up * a, wrap_angle(b - to_z), -c, knee, ankle_pitch, roll};
    for (std::size_t i = 0; i < solution.size(); ++i) {
        const nao::JointDef& joint = *joints_[i];
        const double angle = std::clamp(solution[i], joint.min, joint.max);
        if (std::abs(angle - solution[i]) > 1e-9) exact = false;
        joints[nao::index(joint.id)] = angle;
    }
    return exact;
}

}  // namespace k3d::agent::kinematics
