// SPDX-License-Identifier: BSD-3-Clause
// How the robot has moved since the cycle before, from the foot that stands and the gyro.
#pragma once

#include "agent/kinematics/leg.h"
#include "agent/motion/posture.h"

namespace k3d::agent::motion {

/// The body's shape in one cycle, as measured.
struct BodyShape {
    kinematics::PartPoses parts;
    Vec3 right_sole = Vec3::Zero();  ///< level robot axes, from the torso centre
    Vec3 left_sole = Vec3::Zero();
};

class Odometry {
  public:
    /// Motion since the last call in the frame of that time; `turned` is the heading gained.
    Pose2 update(const BodySense& sense, const BodyShape& shape, double turned);

  private:
    BodyShape before_;
    bool right_stands_ = false;
    bool left_stands_ = false;
    bool started_ = false;
};

}  // namespace k3d::agent::motion
