// SPDX-License-Identifier: BSD-3-Clause
// Rule: kick-off. The ball lies on the centre spot, everybody stands in its own half, the team without
// the ball outside the circle; the first touch begins play. After a goal the other team kicks off.
#pragma once

#include "server/game/soccer/match.h"

namespace k3d::server::game {

/// Of `side`; None: of the left team in the first half, of the right team in the second.
PlayMode kick_off_mode(const GameState& state, wire::Side side);

void before_kick_off(Match& match);
void kick_off(Match& match);
void after_goal(Match& match);

/// Who has kicked off may score once the opponents have touched the ball, or its own team outside the
/// centre circle.
void lift_bar(Match& match);

}  // namespace k3d::server::game
