// SPDX-License-Identifier: BSD-3-Clause
// Play modes, their wire names and monitor indices (reference 7.1).
#pragma once

#include <optional>
#include <string_view>

namespace k3d::server::game {

enum class PlayMode {
    BeforeKickOff, KickOffLeft, KickOffRight, PlayOn, KickInLeft, KickInRight,
    CornerKickLeft, CornerKickRight, GoalKickLeft, GoalKickRight, OffsideLeft, OffsideRight,
    GameOver, GoalLeft, GoalRight, FreeKickLeft, FreeKickRight,
    DirectFreeKickLeft, DirectFreeKickRight, PassLeft, PassRight,
};

/// Before kick-off and after a goal the game pauses: players may beam, no foul is judged.
inline bool paused(PlayMode mode) {
    return mode == PlayMode::BeforeKickOff || mode == PlayMode::GoalLeft ||
           mode == PlayMode::GoalRight;
}

std::string_view name(PlayMode mode);
std::optional<PlayMode> play_mode(std::string_view name);

}  // namespace k3d::server::game
