// SPDX-License-Identifier: BSD-3-Clause
// Rule: kick-in, corner kick, free kicks and goal kick. After a pause the ball lies on its spot until the
// first touch; opponents stay 2 m away, at a goal kick outside the penalty area, which the ball must
// leave. After 15 s the ball is dropped.
#pragma once

#include "server/game/soccer/match.h"

namespace k3d::server::game {

/// One of the modes of this rule, `left_one` being the left team's of its pair.
void set_play(Match& match, PlayMode left_one, wire::Side kicking);
void goal_kick(Match& match);

}  // namespace k3d::server::game
