// SPDX-License-Identifier: BSD-3-Clause
// Leaves out targets that come too late.
#include "agent/decision/keepaway/in_time.h"

#include <algorithm>
#include <limits>

namespace k3d::agent::decision {

void targets_in_time(const std::vector<Vec2>& grid, const Room& room, const Haste& haste,
                     std::vector<Vec2>& out) {
    out.clear();
    double soonest = std::numeric_limits<double>::infinity();
    for (const Vec2& point : grid) {
        if (room(point) < 0.0) continue;
        out.push_back(point);
        soonest = std::min(soonest, haste.ready(point));
    }
    const double latest = std::max(haste.deadline, soonest + haste.patience);
    std::erase_if(out, [&](const Vec2& point) { return haste.ready(point) > latest; });
}

}  // namespace k3d::agent::decision
