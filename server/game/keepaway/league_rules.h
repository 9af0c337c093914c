// SPDX-License-Identifier: BSD-3-Clause
// The league's keepaway challenge (reference 7.5): a box that shrinks with game time; it ends when a taker
// touches the ball or the ball leaves the box. Players may stand where they like.
#pragma once

#include <optional>
#include <string>

#include "server/body/scene.h"
#include "server/game/keepaway/config.h"

namespace k3d::server::game {

/// Side of the box at a game time, m; 0 once it has vanished.
double league_side(const KeepawayConfig& config, double time);

/// Why the episode is over, by the truth after a step at this game time.
std::optional<std::string> broken_league_rule(const KeepawayConfig& config,
                                              const body::Scene& scene, double time);

}  // namespace k3d::server::game
