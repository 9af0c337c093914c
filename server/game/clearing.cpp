// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/clearing.h"

#include <algorithm>
#include <cmath>

#include "common/field/field.h"

namespace k3d::server::game {

namespace {

/// Distance on the ground between a point and a robot's nearest body.
double distance_to(const body::Robot& robot, const Vec3& point) {
    double nearest = (robot.torso_position() - point).head<2>().norm();
    for (std::size_t k = 1; k < robot.model().bodies.size(); ++k) {
        nearest = std::min(nearest, (robot.position(k) - point).head<2>().norm());
    }
    return nearest;
}

}  // namespace

Vec3 sent_back(const Vec3& torso, const Vec3& from, wire::Side team) {
    const double own = team == wire::Side::Left ? -1.0 : 1.0;
    Vec3 to = torso;
    to.x() = from.x() + own * kClearDistance;
    if (std::abs(to.x()) > field::kLength / 2.0) {
        to.x() = torso.x();
        to.y() = from.y() + (from.y() < 0.0 ? kClearDistance : -kClearDistance);
    }
    return to;
}

void clear_ball(body::Scene& scene) {
    const Vec3 ball = scene.ball.position();
    for (const auto& player : scene.players) {
        if (player->team == wire::Side::None) continue;
        if (distance_to(*player->robot, ball) >= field::kCentreRadius) continue;
        player->robot->move(sent_back(player->robot->torso_position(), ball, player->team));
    }
}

void settle_ball(body::Scene& scene) {
    constexpr double kEdge = field::kLength / 2.0 - field::kPenaltyLength;
    constexpr double kHalfWidth = field::kPenaltyWidth / 2.0;
    constexpr double kTouch = field::kWidth / 2.0 - field::kBallRadius;
    Vec3 ball = scene.ball.position();
    const bool in_goal_end = std::abs(ball.x()) > kEdge && std::abs(ball.x()) < field::kLength / 2.0;
    if (in_goal_end && std::abs(ball.y()) < kHalfWidth) {
        ball.x() = std::copysign(kEdge, ball.x());
        ball.y() = std::copysign(kHalfWidth, ball.y());
    }
    ball.y() = std::clamp(ball.y(), -kTouch, kTouch);
    scene.ball.move(ball);
    scene.ball.set_velocity(Vec3::Zero());
}

Vec3 beside_field(const Vec3& ball, int unum, wire::Side team) {
    const double own = team == wire::Side::Left ? -1.0 : 1.0;
    const double other_side = ball.y() < 0.0 ? 1.0 : -1.0;
    return {own * 0.6 * (7 - unum), other_side * (field::kWidth / 2.0 + 0.5), 1.0};
}

}  // namespace k3d::server::game
