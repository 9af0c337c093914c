// SPDX-License-Identifier: BSD-3-Clause
// What the referee notes before it judges: touches, the ball's last place on the field, and modes that
// a trainer has set.
#pragma once

#include "server/game/soccer/match.h"

namespace k3d::server::game {

/// After each step.
void observe(Match& match);
/// For the next step; last of all.
void remember(Match& match);

/// True while the whole ball, or a part of it, is within the lines.
bool on_field(const Vec3& ball);

}  // namespace k3d::server::game
