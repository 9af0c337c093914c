// SPDX-License-Identifier: BSD-3-Clause
// Rule: pass mode. A player beside a ball at rest, no opponent near, may ask for 4 s or until the next
// touch in which opponents stay 1 m away. For 10 s its team cannot score until two of its players have
// touched the ball outside that circle.
#pragma once

#include "server/game/soccer/match.h"

namespace k3d::server::game {

/// `(pass)` of a player. True if the mode begins.
bool ask_for_pass_mode(Match& match, const body::Player& player);

/// In a pass mode: how long it lasts, and who is kept away.
void pass_mode(Match& match);
/// In play: who touches the ball after pass mode.
void follow_passes(Match& match);
bool may_score(Match& match, wire::Side team);
/// For everybody to see: how long either team may not yet score. Only in PlayOn.
void tell_score_wait(Match& match);

}  // namespace k3d::server::game
