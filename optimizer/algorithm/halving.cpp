// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/halving.h"

#include <algorithm>

#include "common/log/log.h"

namespace k3d::optimizer::algorithm {

std::vector<HalvingRound> halve(int candidates, int budget) {
    std::vector<HalvingRound> rounds;
    if (budget <= 0) return rounds;
    for (int left = (candidates + 1) / 2; left >= 2; left = (left + 1) / 2) {
        rounds.push_back({left, 0});
        if (left == 2) break;
    }
    const int count = static_cast<int>(rounds.size());
    for (HalvingRound& round : rounds) {
        round.episodes = std::max(1, budget / count / round.survivors);
    }
    return rounds;
}

std::vector<HalvingRound> finals(int finalists, int episodes) {
    K3D_ASSERT(finalists >= 1 && episodes >= 1);
    std::vector<HalvingRound> rounds;
    for (int left = finalists; left >= 1; left = (left + 1) / 2) {
        rounds.push_back({left, episodes});
        if (left == 1) break;
    }
    int part = episodes;
    for (auto round = rounds.rbegin(); round != rounds.rend(); ++round) {
        round->episodes = part;
        part = (part + 1) / 2;
    }
    return rounds;
}

}  // namespace k3d::optimizer::algorithm
