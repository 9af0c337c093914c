// SPDX-License-Identifier: BSD-3-Clause
// Rule: who takes a set play may not touch the ball again before somebody else has; the opponents then
// get a free kick. What counts as one kick lasts 0.1 s.
#pragma once

#include "server/game/soccer/match.h"

namespace k3d::server::game {

/// The last touch took a set play; `indirect`: no goal may come straight from it.
void note_kick(Match& match, bool indirect);
/// A new set play or a dropped ball: what was before has no consequences.
void forget_kicks(Match& match);

/// True if the rule was broken, and the play mode changed.
bool kicker_touched_twice(Match& match);
/// True while the ball moves from the noted kick, nobody else having touched it.
bool straight_from_kick(const Match& match);

}  // namespace k3d::server::game
