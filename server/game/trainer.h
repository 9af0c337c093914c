// SPDX-License-Identifier: BSD-3-Clause
// What a trainer's command does to scene and game (reference 8.5).
#pragma once

#include <optional>
#include <string_view>

#include "common/wire/trainer.h"
#include "server/game/game.h"

namespace k3d::server::game {

/// What the sessions must do after a command.
struct TrainerEffect {
    bool end_simulation = false;
    std::optional<int> killed;  ///< id of a player to remove
    std::string_view ignored;   ///< why it had no effect; empty: it had
};

/// Carries the command out. A command for an unknown player or mode is ignored (reference A.2).
/// Keepaway ignores play modes, kick-offs, dropped balls and the time: they decide what its row
/// says.
TrainerEffect apply(const wire::TrainerCommand& command, body::Scene& scene, Game& game);

}  // namespace k3d::server::game
