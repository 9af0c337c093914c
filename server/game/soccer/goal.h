// SPDX-License-Identifier: BSD-3-Clause
// Rule: a goal is scored when the ball is in the goal. Not straight from an indirect kick, by the team
// that kicked off from within the circle, or from pass mode: that is a goal kick, or a corner kick if it
// was the kicking team's own goal.
#pragma once

#include "server/game/soccer/match.h"

namespace k3d::server::game {

/// True if the ball went into a goal, and the play mode changed.
bool goal_scored(Match& match);

}  // namespace k3d::server::game
