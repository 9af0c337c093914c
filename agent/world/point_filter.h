// SPDX-License-Identifier: BSD-3-Clause
// Kalman filter of one point's position and velocity on the ground plane.
//
// Metres, m/s, team frame. Both axes share one covariance, since measurements are taken to be as
// uncertain in x as in y. Between measurements dv/dt = -decay v + white noise.
#pragma once

#include "common/math/geometry.h"

namespace k3d::agent::world {

class PointFilter {
  public:
    void start(const Vec2& position, double position_sd, const Vec2& velocity, double velocity_sd);
    /// `decay` 1/s, 0 = steady motion; `acceleration_sd` m/s^1.5.
    void predict(double dt, double decay, double acceleration_sd);
    /// The velocity may have changed by `speed_sd` at some moment of the last `dt` seconds.
    void disturb(double speed_sd, double dt);
    void measure(const Vec2& position, double sd);
    /// Expresses the state in a frame that was corrected: `from` is now known to have been `to`.
    void reseat(const Pose2& from, const Pose2& to);

    /// Squared distance of a measurement from what is expected, in deviations.
    double surprise(const Vec2& position, double sd) const;
    const Vec2& position() const { return position_; }
    const Vec2& velocity() const { return velocity_; }
    double velocity_sd() const { return std::sqrt(velocity_variance_); }

  private:
    Vec2 position_ = Vec2::Zero();
    Vec2 velocity_ = Vec2::Zero();
    double position_variance_ = 1e6;
    double covariance_ = 0.0;
    double velocity_variance_ = 1e6;
};

}  // namespace k3d::agent::world
