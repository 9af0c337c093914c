// SPDX-License-Identifier: BSD-3-Clause
// Rule: a ball out of play goes to the team that did not touch it last: kick-in over the side line, goal
// kick or corner kick over the goal line.
#pragma once

#include "server/game/soccer/match.h"

namespace k3d::server::game {

void award_kick_in(Match& match, wire::Side team);
void award_corner_kick(Match& match, wire::Side team);
void award_goal_kick(Match& match, wire::Side team);

/// True if the ball has left the field, and the play mode changed.
bool ball_out(Match& match);

}  // namespace k3d::server::game
