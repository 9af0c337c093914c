// SPDX-License-Identifier: BSD-3-Clause
// Who may speak when: a listener hears one team-mate in two cycles and the first speaker wins
// (reference 3.7), so the keepers take turns by the server's clock.
#pragma once

#include <cmath>
#include <cstdint>

#include "common/clock/clock.h"

namespace k3d::agent::talk {

/// Keeper `unum` of `keepers` speaks in cycles with (cycle mod 2 * keepers) = 2 * (unum - 1).
/// Numbers beyond `keepers` share the slots. `now`: simulation time of the frame, s.
inline bool may_speak(double now, int unum, int keepers) {
    const auto cycle = static_cast<std::int64_t>(std::llround(now / kCycleSeconds));
    return cycle % (2 * keepers) == 2 * ((unum - 1) % keepers);
}

/// Counts the rounds of talk: everybody speaks once in each.
inline std::int64_t round_of(double now, int keepers) {
    return std::llround(now / kCycleSeconds) / (2 * keepers);
}

}  // namespace k3d::agent::talk
