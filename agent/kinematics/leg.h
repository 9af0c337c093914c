// SPDX-License-Identifier: BSD-3-Clause
// Closed-form inverse kinematics of a leg with the Nao's yaw-pitch hip.
//
// Frame: torso, agent axes (forward.h). A foot is placed by its sole point: the point of the sole
// straight below the ankle when the leg is at zero pose. Metres, radians.
#pragma once

#include "agent/kinematics/forward.h"

namespace k3d::agent::kinematics {

enum class Side { Right, Left };

/// The joints of a leg, from the hip down.
using LegJoints = std::array<nao::JointId, 6>;
inline constexpr LegJoints kRightLeg{nao::JointId::RHipYawPitch, nao::JointId::RHipRoll,
                                     nao::JointId::RHipPitch,    nao::JointId::RKneePitch,
                                     nao::JointId::RAnklePitch,  nao::JointId::RAnkleRoll};
inline constexpr LegJoints kLeftLeg{nao::JointId::LHipYawPitch, nao::JointId::LHipRoll,
                                    nao::JointId::LHipPitch,    nao::JointId::LKneePitch,
                                    nao::JointId::LAnklePitch,  nao::JointId::LAnkleRoll};

/// Where a sole is: its point and the foot's axes, in the torso frame.
using SolePose = PartPose;

/// The leg's lengths and fixed angles, all derived from the table.
class Leg {
  public:
    Leg(const nao::Model& model, Side side);

    /// Centre of the hip, where its three axes meet.
    const Vec3& hip() const { return hip_; }
    /// Sole pose of the straight leg.
    SolePose zero_pose() const;
    /// Sole pose of the leg in `parts`.
    SolePose sole(const PartPoses& parts) const;

    /// Writes the six leg angles that bring the sole there. Out of reach: the leg stretches as far
    /// as it goes towards the hip-ankle direction wanted and false is returned. Angles are clamped
    /// to the stops; that also returns false.
    bool solve(const SolePose& target, nao::JointArray& joints) const;

  private:
    std::array<const nao::JointDef*, 6> joints_;  ///< hip yaw-pitch ... ankle roll
    nao::Part foot_;
    Vec3 hip_;           ///< torso frame
    double hip_axis_;    ///< elevation of the yaw-pitch axis in the frontal plane, from +y
    Vec3 thigh_;         ///< hip -> knee axis at zero pose
    Vec3 shank_;         ///< knee axis -> ankle pitch axis at zero pose
    Vec3 ankle_;         ///< ankle pitch axis -> ankle roll axis at zero pose
    Vec3 sole_;          ///< ankle roll axis -> sole point, foot frame
    Vec3 sole_in_foot_;  ///< foot centre -> sole point, foot frame
};

}  // namespace k3d::agent::kinematics
