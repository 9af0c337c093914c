// SPDX-License-Identifier: BSD-3-Clause
// Gyro and accelerometer in the torso (reference 3.4). Torso frame, deg/s and m/s^2, no noise.
#pragma once

#include "server/body/robot.h"

namespace k3d::server::percepts {

Vec3 gyro_deg(const body::Robot& robot);

/// Lags one step: velocity is sampled before a step, so the reading after it is of the step before.
class Accelerometer {
  public:
    void sample_before_step(const body::Robot& robot);
    const Vec3& reading() const { return reading_; }

  private:
    Vec3 velocity_ = Vec3::Zero();
    Vec3 reading_{0.0, 0.0, 9.81};
};

}  // namespace k3d::server::percepts
