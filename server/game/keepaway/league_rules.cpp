// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/keepaway/league_rules.h"

#include <algorithm>
#include <cmath>

#include "server/game/state.h"

namespace k3d::server::game {

double league_side(const KeepawayConfig& config, double time) {
    return std::max(0.0, config.league_side - config.league_shrink * time / 60.0);
}

std::optional<std::string> broken_league_rule(const KeepawayConfig& config,
                                              const body::Scene& scene, double time) {
    const double half = league_side(config, time) / 2.0;
    const Vec3 ball = scene.ball.position();
    if (std::abs(ball.x()) > half || std::abs(ball.y()) > half) return "ball_out";
    for (const int id : ball_touchers(scene.world.contacts())) {
        for (const auto& player : scene.players) {
            if (player->id == id && player->team == wire::Side::Right) return "taker_touched_ball";
        }
    }
    return std::nullopt;
}

}  // namespace k3d::server::game
