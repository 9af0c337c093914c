// SPDX-License-Identifier: BSD-3-Clause
#include "agent/world/point_filter.h"

namespace k3d::agent::world {

void PointFilter::start(const Vec2& position, double position_sd, const Vec2& velocity,
                        double velocity_sd) {
    position_ = position;
    velocity_ = velocity;
    position_variance_ = position_sd * position_sd;
    covariance_ = 0.0;
    velocity_variance_ = velocity_sd * velocity_sd;
}

void PointFilter::predict(double dt, double decay, double acceleration_sd) {
    const double kept = std::exp(-decay * dt);
    const double reach = decay > 0.0 ? (1.0 - kept) / decay : dt;
    position_ += reach * velocity_;
    velocity_ *= kept;
    const double noise = acceleration_sd * acceleration_sd;
    position_variance_ +=
        2.0 * reach * covariance_ + reach * reach * velocity_variance_ + noise * dt * dt * dt / 3.0;
    covariance_ = kept * (covariance_ + reach * velocity_variance_) + noise * dt * dt / 2.0;
    velocity_variance_ = kept * kept * velocity_variance_ + noise * dt;
}

void PointFilter::disturb(double speed_sd, double dt) {
    const double variance = speed_sd * speed_sd;
    position_variance_ += variance * dt * dt;
    covariance_ += variance * dt;
    velocity_variance_ += variance;
}

void PointFilter::measure(const Vec2& position, double sd) {
    const double total = position_variance_ + sd * sd;
    const Vec2 error = position - position_;
    const double position_gain = position_variance_ / total;
    const double velocity_gain = covariance_ / total;
    position_ += position_gain * error;
    velocity_ += velocity_gain * error;
    velocity_variance_ -= velocity_gain * covariance_;
    covariance_ *= 1.0 - position_gain;
    position_variance_ *= 1.0 - position_gain;
}

void PointFilter::reseat(const Pose2& from, const Pose2& to) {
    position_ = to.to_global(from.to_local(position_));
    velocity_ = rotated(velocity_, wrap_angle(to.yaw - from.yaw));
}

double PointFilter::surprise(const Vec2& position, double sd) const {
    return (position - position_).squaredNorm() / (position_variance_ + sd * sd);
}

}  // namespace k3d::agent::world
