// SPDX-License-Identifier: BSD-3-Clause
// Where everybody begins (paper section 2): keepers on a circle, takers along the right side,
// the ball with the keeper that is farthest from the takers. Field frame, m, rad.
#pragma once

#include <vector>

#include "common/random/stream.h"
#include "server/game/keepaway/config.h"
#include "common/math/geometry.h"

namespace k3d::server::game {

inline constexpr double kStartRadiusPerSide = 0.25;  // keepers' circle
inline constexpr double kCornerInset = 0.3;          // m, takers inside the corner
inline constexpr double kBallAhead = 0.3;            // m, ball before its keeper

struct Start {
    std::vector<Pose2> keepers;  ///< by unum - 1
    std::vector<Pose2> takers;
    Vec2 ball;
};

Start make_start(const KeepawayConfig& config, RandomStream random);

}  // namespace k3d::server::game
