// SPDX-License-Identifier: BSD-3-Clause
// What a decision is: a request to the body, a message to the team, and an account of why.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "agent/motion/motion.h"
#include "agent/talk/message.h"
#include "common/math/geometry.h"

namespace k3d::agent::decision {

/// A place that was considered, and what it costs; team frame.
struct Scored {
    Vec2 point = Vec2::Zero();
    double cost = 0.0;
};

/// For telemetry: what was decided and on what grounds. Team frame.
struct Account {
    std::string role;                 ///< "K1", "K2", "K3", "chaser", "follower", "idle"
    std::string skill;                ///< "intercept", "position", "go_home", "search", ...
    int k1 = 0;                       ///< unum of the keeper taken for K1 (keepers: a team-mate; takers: an opponent)
    int k2 = 0;                       ///< K1: whom it names; follower: whom it follows
    std::optional<Vec2> target;       ///< kick target (K1) or place to be at
    double cost = 0.0;                ///< K1: of the target
    std::span<const Scored> scored;   ///< K1: targets it has scored in this cycle; valid until the next
    double taker_distance = -1.0;     ///< m, nearest taker to the ball; -1 = none known
};

struct Decision {
    motion::Request request;
    std::optional<talk::Message> say;  ///< to be said when it is this player's turn
    Account account;
};

}  // namespace k3d::agent::decision
