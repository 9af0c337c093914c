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

bool any_part_in(const body::Robot& robot, const Area& area) {
    for (std::size_t k = 0; k < robot.model().bodies.size(); ++k) {
        if (area.contains(robot.position(k).head<2>())) return true;
    }
    return false;
}

bool within_centre_circle(const body::Robot& robot, double radius) {
    for (std::size_t k = 0; k < robot.model().bodies.size(); ++k) {
        if (robot.position(k).head<2>().norm() >= radius) return false;
    }
    return true;
}

/// Moves the player there, or as near to it as leaves room for two robots, to either side.
void move_apart(body::Scene& scene, body::Player& player, const Vec3& wanted) {
    constexpr double kApart = 2.0 * field::kAgentRadius;
    const auto taken = [&](const Vec3& spot) {
        return std::any_of(scene.players.begin(), scene.players.end(), [&](const auto& other) {
            const Vec3 torso = other->robot->torso_position();
            return other->id != player.id && (torso - spot).head<2>().norm() < kApart;
        });
    };
    constexpr int kTries = 12;
    Vec3 spot = wanted;
    for (int k = 1; k <= kTries && taken(spot); ++k) {
        spot.y() = wanted.y() + (k % 2 == 0 ? -kApart : kApart) * ((k + 1) / 2);
    }
    player.robot->move(taken(spot) ? wanted : spot);
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

void clear_circle(body::Scene& scene, const Vec3& centre, double radius, wire::Side team) {
    for (const auto& player : scene.players) {
        if (player->team != team || distance_to(*player->robot, centre) >= radius) continue;
        move_apart(scene, *player, sent_back(player->robot->torso_position(), centre, team));
    }
}

void clear_area(body::Scene& scene, const Area& area, wire::Side team, double spared_radius) {
    for (const auto& player : scene.players) {
        if (player->team != team || !any_part_in(*player->robot, area)) continue;
        if (within_centre_circle(*player->robot, spared_radius)) continue;
        Vec3 to = player->robot->torso_position();
        to.x() = team == wire::Side::Left ? area.min_x - kClearDistance
                                          : area.max_x + kClearDistance;
        move_apart(scene, *player, to);
    }
}

void repel(body::Scene& scene, const Vec3& centre, double radius, double pad, wire::Side team) {
    for (const auto& player : scene.players) {
        const Vec3 torso = player->robot->torso_position();
        const Vec2 away = (torso - centre).head<2>();
        if (player->team != team || away.norm() >= radius) continue;
        // From its very middle, towards the own goal.
        const Vec2 out = away.norm() > 1e-6 ? away.normalized()
                                            : Vec2(team == wire::Side::Left ? -1.0 : 1.0, 0.0);
        const Vec2 to = centre.head<2>() + (radius + pad) * out;
        move_apart(scene, *player, {to.x(), to.y(), torso.z()});
    }
}

void clear_ball(body::Scene& scene) {
    for (const wire::Side team : {wire::Side::Left, wire::Side::Right}) {
        clear_circle(scene, scene.ball.position(), field::kCentreRadius, team);
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
