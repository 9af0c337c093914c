// SPDX-License-Identifier: BSD-3-Clause
// Geometry and timing of a meeting with a rolling ball.
#include "agent/skills/intercept.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/field/field.h"

namespace k3d::agent::skills {

Vec2 perpendicular_foot(const Vec2& self, const world::Ball& ball) {
    const Vec2 path = ball.finish - ball.position;
    const double squared = path.squaredNorm();
    if (squared < 1e-9) return ball.finish;
    const double share = std::clamp((self - ball.position).dot(path) / squared, 0.0, 1.0);
    return ball.position + share * path;
}

double roll_time(double along, double total) {
    if (along <= 0.0) return 0.0;
    if (along >= total) return std::numeric_limits<double>::infinity();
    // v(t) = v0 exp(-k t) travels total * (1 - exp(-k t)) of its way.
    return -std::log(1.0 - along / total) / field::kRollDecay;
}

Vec2 earliest_meeting(const Vec2& self, const world::Ball& ball, double speed) {
    constexpr double kStep = 0.05;         // m along the path
    constexpr double kMargin = 0.4;        // s to stop and turn
    const Vec2 path = ball.finish - ball.position;
    const double total = path.norm();
    if (total < kStep) return ball.finish;
    for (double along = 0.0; along < total; along += kStep) {
        const Vec2 point = ball.position + path * (along / total);
        if ((point - self).norm() / speed + kMargin <= roll_time(along, total)) return point;
    }
    return ball.finish;
}

}  // namespace k3d::agent::skills
