// SPDX-License-Identifier: BSD-3-Clause
// How the robot has moved since the cycle before, from the foot that stands and the gyro.
//
// Soles slide a little on the ground (contact slip, reference 5.5), on average forwards in the
// direction of the walk: measured legs alone tell 5 % (0.4 m/s) to 15 % (0.8 m/s) too little. The
// scales of motion's configuration take out the mean. Metres, radians.
#pragma once

#include "agent/kinematics/leg.h"
#include "agent/motion/posture.h"

namespace k3d::agent::motion {

/// Sole points in one cycle as measured: level robot axes, from the torso centre.
struct Soles {
    Vec3 right = Vec3::Zero();
    Vec3 left = Vec3::Zero();
};

class Odometry {
  public:
    /// Motion since the last call in the frame of that time; `turned` is the heading gained.
    Pose2 update(const BodySense& sense, const Soles& soles, double turned);

  private:
    Soles before_;
    bool right_stands_ = false;
    bool left_stands_ = false;
    bool started_ = false;
};

}  // namespace k3d::agent::motion
