// SPDX-License-Identifier: BSD-3-Clause
// The game as everybody is told of it, and which robots touch the ball.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "server/body/scene.h"
#include "server/game/play_mode.h"

namespace k3d::server::game {

/// s, of comparisons with a time: a sum of cycles, in the longest match of 20 hours off by 3e-6.
inline constexpr double kTimeSlack = 1e-5;

struct GameState {
    PlayMode mode = PlayMode::BeforeKickOff;
    double time = 0.0;        ///< game time, s: stands still in BeforeKickOff and GameOver
    double mode_time = 0.0;   ///< simulated time since the mode was entered, s
    int half = 1;             ///< 1 or 2
    int score_left = 0;
    int score_right = 0;
    std::string team_left, team_right;  ///< empty until known
    double pass_wait_left = 0.0;   ///< s in which goals after pass mode do not count; 0: they do
    double pass_wait_right = 0.0;

    /// To be in a mode already changes nothing.
    void enter(PlayMode next) {
        if (mode == next) return;
        mode = next;
        mode_time = 0.0;
    }
    /// One cycle later.
    void advance();
};

/// Ids of the players whose robots touched the ball in the last step.
std::vector<int> ball_touchers(std::span<const physics::Contact> contacts);

}  // namespace k3d::server::game
