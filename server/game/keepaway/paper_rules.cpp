// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/keepaway/paper_rules.h"

#include <cmath>

namespace k3d::server::game {

namespace {

bool in_torso_column(nao::Part part) {
    return part == nao::Part::Torso || part == nao::Part::Neck || part == nao::Part::Head;
}

bool taker_at_ball(const KeepawayConfig& config, const body::Scene& scene) {
    const bool any_part = config.taker_part == "any_part";
    const Vec2 ball = scene.ball.position().head<2>();
    for (const auto& player : scene.players) {
        if (player->team != wire::Side::Right) continue;
        const auto& bodies = player->robot->model().bodies;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (!any_part && !in_torso_column(bodies[i].part)) continue;
            const Vec2 part = player->robot->position(i).head<2>();
            if ((part - ball).norm() < config.taker_reach) return true;
        }
    }
    return false;
}

}  // namespace

std::optional<std::string> broken_paper_rule(const KeepawayConfig& config,
                                             const body::Scene& scene) {
    const auto outside = [half = config.side / 2.0](const Vec3& point) {
        return std::abs(point.x()) > half || std::abs(point.y()) > half;
    };
    if (taker_at_ball(config, scene)) return "taker_reached_ball";
    if (outside(scene.ball.position())) return "ball_out";
    for (const auto& player : scene.players) {
        if (player->team == wire::Side::Left && outside(player->robot->torso_position())) {
            return "keeper_out";
        }
    }
    return std::nullopt;
}

}  // namespace k3d::server::game
