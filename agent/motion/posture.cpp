// SPDX-License-Identifier: BSD-3-Clause
#include "agent/motion/posture.h"

#include <algorithm>
#include <cmath>

#include "common/clock/clock.h"

namespace k3d::agent::motion {

namespace {

constexpr double kGravity = 9.81;
// The gyro is noise-free and rounded to 0.01 deg/s, so it drifts by less than 0.3 degrees a minute:
// the accelerometer needs to pull only slowly, and steps of the walk average out.
constexpr double kWalkingPull = 0.004;  // per cycle
constexpr double kRestingPull = 0.1;    // per cycle, lying or standing still
constexpr double kWalkingError = 1.5;   // m/s^2, length of the accelerometer against g
constexpr double kRestingError = 0.25;  // m/s^2
constexpr double kRestingRate = 0.1;    // rad/s
constexpr int kRestingCycles = 10;

/// Rotation that takes `up` to z and the torso's forward axis to the x-z plane.
Quat levelled(const Vec3& up) {
    // Lying on face or back the forward axis points along the vertical: then the head's direction
    // (lying on the back it points backwards) gives the heading.
    const Vec3 forward = std::abs(up.x()) < 0.9
                             ? Vec3(Vec3::UnitX())
                             : Vec3(up.x() > 0.0 ? -Vec3::UnitZ() : Vec3(Vec3::UnitZ()));
    const Vec3 x = (forward - forward.dot(up) * up).normalized();
    Mat3 rows;
    rows.row(0) = x;
    rows.row(1) = up.cross(x);
    rows.row(2) = up;
    return Quat(rows);
}

}  // namespace

const Posture& PostureFilter::update(const BodySense& sense) {
    const double dt = started_ ? std::clamp(sense.time - last_time_, 0.0, 0.1) : 0.0;
    last_time_ = sense.time;
    const double force = sense.acceleration.norm();
    Vec3 up = posture_.up;
    if (!started_) {
        started_ = true;
        if (force > 1.0) up = sense.acceleration / force;
    }
    const double angle = sense.gyro.norm() * dt;
    if (angle > 0.0) {
        up = Eigen::AngleAxisd(-angle, sense.gyro.normalized()).toRotationMatrix() * up;
    }
    const double error = std::abs(force - kGravity);
    const bool resting = error < kRestingError && sense.gyro.norm() < kRestingRate;
    calm_cycles_ = resting ? calm_cycles_ + 1 : 0;
    if (error < kWalkingError) {
        const double pull = calm_cycles_ >= kRestingCycles ? kRestingPull : kWalkingPull;
        up += pull * (sense.acceleration / force - up);
    }
    up.normalize();
    turned_ = sense.gyro.dot(up) * dt;

    posture_.up = up;
    posture_.torso = levelled(up);
    posture_.rate = sense.gyro;
    posture_.roll = std::atan2(up.y(), up.z());
    posture_.pitch = std::atan2(-up.x(), std::hypot(up.y(), up.z()));
    return posture_;
}

}  // namespace k3d::agent::motion
