// SPDX-License-Identifier: BSD-3-Clause
#include "server/percepts/inertial.h"

#include "common/clock/clock.h"

namespace k3d::server::percepts {

namespace {
const Vec3 kGravity(0.0, 0.0, -9.81);
}

Vec3 gyro_deg(const body::Robot& robot) {
    const Vec3 in_torso = robot.torso_rotation().conjugate() * robot.torso_angular_velocity();
    return in_torso * (180.0 / kPi);
}

void Accelerometer::sample_before_step(const body::Robot& robot) {
    const Vec3 velocity = robot.torso_velocity();
    reading_ = robot.torso_rotation().conjugate() *
               ((velocity - velocity_) / kCycleSeconds - kGravity);
    velocity_ = velocity;
}

}  // namespace k3d::server::percepts
