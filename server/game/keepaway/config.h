// SPDX-License-Identifier: BSD-3-Clause
// Settings of the keepaway game (paper section 2; what the paper leaves open is fixed here).
#pragma once

#include <string>

#include "common/config/fields.h"

namespace k3d::server::game {

struct KeepawayConfig {
    std::string rules = "paper";
    double side = 10.0;
    double league_side = 20.0;
    double league_shrink = 4.0;
    int keepers = 3;
    int takers = 2;
    double limit = 300.0;
    double before_kick_off = 3.0;
    double taker_reach = 0.2;
    std::string taker_part = "torso_column";
    double jitter = 0.1;
    double jitter_yaw_deg = 5.0;

    void describe(config::Fields& f) {
        f.text("rules", rules, {"paper", "league"},
               "paper: fixed square, ends by taker, ball or keeper; league: the challenge of the 3-D "
               "league, a box that shrinks, ends when a taker touches the ball or it leaves the box");
        f.number("side", side, {8.0, 14.0}, "m", "paper: side of the square area about the centre");
        f.number("league_side", league_side, {4.0, 20.0}, "m", "league: side of the box at first");
        f.number("league_shrink", league_shrink, {0.0, 60.0}, "m/min", "league: what its side loses");
        f.integer("keepers", keepers, {1, 11}, "players", "left team's seats");
        f.integer("takers", takers, {1, 11}, "players", "right team's seats");
        f.number("limit", limit, {1.0, 3600.0}, "s", "an episode still running then is truncated");
        f.number("before_kick_off", before_kick_off, {0.1, 60.0}, "s", "pause before PlayOn");
        f.number("taker_reach", taker_reach, {0.01, 2.0}, "m",
                 "a taker this near to the ball, on the ground plane, ends the episode");
        f.text("taker_part", taker_part, {"torso_column", "any_part"},
               "which of the taker's parts count: torso, neck and head, or all");
        f.number("jitter", jitter, {0.0, 1.0}, "m", "seeded +- offset of each start position");
        f.number("jitter_yaw_deg", jitter_yaw_deg, {0.0, 180.0}, "deg",
                 "seeded +- offset of each start heading");
    }

    bool league() const { return rules == "league"; }
    /// Side of the area in which play begins.
    double start_side() const { return league() ? league_side : side; }
};

}  // namespace k3d::server::game
