// SPDX-License-Identifier: BSD-3-Clause
// Rule: a ball that nobody plays is dropped. It lies still outside the penalty areas, everybody is sent
// 2.5 m away from it, and anybody may play it.
#pragma once

#include "server/game/soccer/match.h"

namespace k3d::server::game {

void drop_ball(Match& match, const Vec3& spot);

}  // namespace k3d::server::game
