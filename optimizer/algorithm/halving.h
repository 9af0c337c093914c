// SPDX-License-Identifier: BSD-3-Clause
// Sequential halving: episodes where they decide, on those that are still in the running.
// Source: Z. Karnin, T. Koren, O. Somekh, ICML 2013 (fixed-budget best-arm identification).
#pragma once

#include <vector>

namespace k3d::optimizer::algorithm {

struct HalvingRound {
    int survivors;  ///< the best so many candidates play on
    int episodes;   ///< halve(): further ones per survivor; finals(): of a survivor in all
    bool operator==(const HalvingRound&) const = default;
};

/// Rounds that share `budget` further episodes equally, the first among the better half, the last
/// among two; each gives at least one episode. Empty without budget or with fewer than 3 candidates.
std::vector<HalvingRound> halve(int candidates, int budget);

/// Rounds after which the winner of `finalists` has `episodes` in all: everybody begins with an equal
/// part, and as the field halves the number doubles, so that rounds cost about the same.
std::vector<HalvingRound> finals(int finalists, int episodes);

}  // namespace k3d::optimizer::algorithm
