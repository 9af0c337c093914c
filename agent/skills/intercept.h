// SPDX-License-Identifier: BSD-3-Clause
// Where to meet a rolling ball (paper 4.1, INTERCEPT). Team frame, metres, seconds.
#pragma once

#include "agent/world/beliefs.h"
#include "common/math/geometry.h"

namespace k3d::agent::skills {

/// Foot of the perpendicular from `self` on the ball's remaining path, from where it is to where it
/// will stop.
Vec2 perpendicular_foot(const Vec2& self, const world::Ball& ball);

/// Seconds until the ball, which loses speed as 1.06 1/s times its speed, is `along` metres down a
/// path of `total` metres. Infinite at the end of the path.
double roll_time(double along, double total);

/// First point of the path that a robot walking `speed` m/s reaches no later than the ball; the
/// stopping point if there is none before it.
Vec2 earliest_meeting(const Vec2& self, const world::Ball& ball, double speed);

}  // namespace k3d::agent::skills
