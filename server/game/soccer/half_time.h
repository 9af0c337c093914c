// SPDX-License-Identifier: BSD-3-Clause
// Rule: two halves. The second begins in BeforeKickOff, sides stay; the match ends in GameOver.
#pragma once

#include "server/game/soccer/match.h"

namespace k3d::server::game {

void end_half(Match& match);

}  // namespace k3d::server::game
