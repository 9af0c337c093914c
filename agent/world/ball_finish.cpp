// SPDX-License-Identifier: BSD-3-Clause
#include "agent/world/ball_finish.h"

namespace k3d::agent::world {

void BallFinish::reset() {
    last_.reset();
    sum_ = Vec2::Zero();
    weight_ = 0.0;
}

void BallFinish::add(const Vec2& position, double time) {
    if (last_) {
        const double dt = time - last_time_;
        if (dt <= 0.0) return;
        const Vec2 velocity = (position - *last_) / dt;
        const double kept = std::exp(-dt / lambda_);
        sum_ = kept * sum_ + position + alpha_ * velocity;
        weight_ = kept * weight_ + 1.0;
    }
    last_ = position;
    last_time_ = time;
}

std::optional<Vec2> BallFinish::estimate() const {
    if (weight_ <= 0.0) return std::nullopt;
    return Vec2(sum_ / weight_);
}

}  // namespace k3d::agent::world
