// SPDX-License-Identifier: BSD-3-Clause
// How the torso is oriented: gyro and accelerometer joined in one estimate without heading.
//
// Agent axes: x forward, y left, z up. Radians, seconds.
#pragma once

#include "agent/motion/motion.h"

namespace k3d::agent::motion {

/// Torso against the vertical, with rates.
struct Posture {
    Quat torso = Quat::Identity();  ///< torso axes -> level frame of the same heading
    double roll = 0.0;              ///< about forward: positive leans to the right
    double pitch = 0.0;             ///< about left: positive leans forward
    Vec3 rate = Vec3::Zero();       ///< gyro, rad/s about x forward, y left, z up
    Vec3 up = Vec3::UnitZ();        ///< the vertical in torso axes; up.z is the cosine of the tilt
};

/// Integrates the gyro and pulls the vertical slowly to the accelerometer where that can be
/// believed, that is where its length is close to g; faster while the robot rests.
class PostureFilter {
  public:
    const Posture& update(const BodySense& sense);
    const Posture& posture() const { return posture_; }
    double turned() const { return turned_; }  ///< heading gained in the last cycle, rad

  private:
    Posture posture_;
    double last_time_ = 0.0;
    double turned_ = 0.0;
    int calm_cycles_ = 0;  ///< cycles in a row with a believable accelerometer
    bool started_ = false;
};

}  // namespace k3d::agent::motion
