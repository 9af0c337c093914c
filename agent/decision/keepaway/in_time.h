// SPDX-License-Identifier: BSD-3-Clause
// Which targets K1 can still kick at before a taker is at the ball. Metres, seconds.
#pragma once

#include <functional>
#include <vector>

#include "agent/decision/keepaway/policy.h"
#include "common/math/geometry.h"

namespace k3d::agent::decision {

/// When the ball must have gone, and how long K1 needs for a kick at a point.
struct Haste {
    double deadline = 0.0;  ///< s from now
    double patience = 0.0;  ///< s: if no target is in time, those not later than the soonest by this
    std::function<double(const Vec2&)> ready;  ///< s from now
};

/// Those of the grid that have room (policy.h) and are in time, in its order; none if none has
/// room.
void targets_in_time(const std::vector<Vec2>& grid, const Room& room, const Haste& haste,
                     std::vector<Vec2>& out);

}  // namespace k3d::agent::decision
