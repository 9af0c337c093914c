// SPDX-License-Identifier: BSD-3-Clause
// Settings of a soccer match, and the times and distances of its rules (reference 7.3).
#pragma once

#include "common/config/fields.h"

namespace k3d::server::game {

struct SoccerConfig {
    double half_time = 300.0;
    bool referee = true;
    bool automatic_kick_off = false;
    double kick_off_wait = 30.0;
    bool type_quotas = true;
    bool ends = false;

    void describe(config::Fields& f) {
        f.number("half_time", half_time, {1.0, 36000.0}, "s", "length of each of the two halves");
        f.boolean("referee", referee,
                  "false: only the clock, the ball in BeforeKickOff, and the ways to PlayOn");
        f.boolean("automatic_kick_off", automatic_kick_off,
                  "kick off without a trainer, kick_off_wait after a half could begin");
        f.number("kick_off_wait", kick_off_wait, {0.1, 3600.0}, "s", "time to take positions");
        f.boolean("type_quotas", type_quotas,
                  "a team has at most 7 robots of one type and 9 of two types, and 3 types in all");
        f.boolean("ends", ends, "the server ends after GameOver");
    }
};

inline constexpr double kGoalPause = 3.0;          // s
inline constexpr double kKickInPause = 1.0;        // s between a ball out of play and its return
inline constexpr double kDropBallTime = 15.0;      // s without a touch until the ball is dropped
inline constexpr double kFreeKickDistance = 2.0;   // m that opponents keep from a kick
inline constexpr double kKickRepelDistance = 0.5;  // m that the kicking team keeps while it is placed
inline constexpr double kGoalKickDistance = 1.0;   // m from the goal line
inline constexpr double kKickDuration = 0.1;       // s, one kick may touch the ball several times

inline constexpr double kPassMaxBallSpeed = 0.05;       // m/s
inline constexpr double kPassMaxBallDistance = 0.5;     // m, of who asks for pass mode
inline constexpr double kPassMinOpponentDistance = 1.0;  // m from the ball
inline constexpr double kPassDuration = 4.0;            // s
inline constexpr double kPassScoreWait = 10.0;          // s without a goal, unless the ball was passed
inline constexpr double kPassRetryWait = 3.0;           // s

}  // namespace k3d::server::game
