// SPDX-License-Identifier: BSD-3-Clause
// Moving players out of the way, and where they are put (reference 7.3, 8.5). Field frame, m.
#pragma once

#include "server/body/scene.h"

namespace k3d::server::game {

inline constexpr double kClearDistance = 2.5;  ///< that a player in the way is moved by

/// Where a player that is sent away from `from` goes: towards its own side, sideways if that would
/// leave the field.
Vec3 sent_back(const Vec3& torso, const Vec3& from, wire::Side team);

/// Sends every player that stands nearer to the ball than the free-kick distance away from it.
void clear_ball(body::Scene& scene);

/// Puts the ball to rest where it may be dropped: inside the field, outside the penalty areas.
void settle_ball(body::Scene& scene);

/// Outside the touch line that the ball is farther from, by number.
Vec3 beside_field(const Vec3& ball, int unum, wire::Side team);

}  // namespace k3d::server::game
