// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/play_mode.h"

#include <array>

namespace k3d::server::game {

namespace {
constexpr std::array<std::string_view, 21> kNames{
    "BeforeKickOff",    "KickOff_Left",          "KickOff_Right",
    "PlayOn",           "KickIn_Left",           "KickIn_Right",
    "corner_kick_left", "corner_kick_right",     "goal_kick_left",
    "goal_kick_right",  "offside_left",          "offside_right",
    "GameOver",         "Goal_Left",             "Goal_Right",
    "free_kick_left",   "free_kick_right",       "direct_free_kick_left",
    "direct_free_kick_right", "pass_left",       "pass_right"};
}

std::string_view name(PlayMode mode) { return kNames[static_cast<std::size_t>(mode)]; }

std::optional<PlayMode> play_mode(std::string_view name) {
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        if (kNames[i] == name) return static_cast<PlayMode>(i);
    }
    return std::nullopt;
}

}  // namespace k3d::server::game
