// SPDX-License-Identifier: BSD-3-Clause
// Tests of optimizer/algorithm/halving: rounds, their cost, and what they are good for.
#include "optimizer/algorithm/halving.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "common/random/stream.h"
#include "optimizer/algorithm/score.h"

namespace k3d::optimizer::algorithm {
namespace {

TEST(Halving, SharesTheBudgetOverItsRounds) {
    EXPECT_EQ(halve(16, 48), (std::vector<HalvingRound>{{8, 2}, {4, 4}, {2, 8}}));
    EXPECT_EQ(halve(60, 0), std::vector<HalvingRound>{});
    EXPECT_EQ(halve(2, 100), std::vector<HalvingRound>{});
    EXPECT_EQ(halve(16, 3), (std::vector<HalvingRound>{{8, 1}, {4, 1}, {2, 1}}));
}

TEST(Finals, TheWinnerHasAllEpisodes) {
    EXPECT_EQ(finals(4, 100), (std::vector<HalvingRound>{{4, 25}, {2, 50}, {1, 100}}));
    EXPECT_EQ(finals(1, 100), (std::vector<HalvingRound>{{1, 100}}));
    EXPECT_EQ(finals(5, 8), (std::vector<HalvingRound>{{5, 1}, {3, 2}, {2, 4}, {1, 8}}));
}

/// Plays 60 candidates whose true means spread by 0.2 about 3.1, with noise of 1.29 an episode and
/// 1,200 episodes in all; the true mean of the one chosen and what it seemed to be.
struct Choice {
    double truth = 0.0;
    double seeming = 0.0;
};

Choice choose(bool by_halving, RandomStream& stream) {
    std::vector<double> truth(60);
    for (double& t : truth) t = 3.1 + 0.2 * stream.normal();
    const auto play = [&](std::size_t i, int episodes) {
        std::vector<double> values;
        for (int k = 0; k < episodes; ++k) values.push_back(truth[i] + 1.29 * stream.normal());
        return score_of(values);
    };
    std::vector<Outcome> outcomes;
    for (std::size_t i = 0; i < 60; ++i) outcomes.push_back({false, play(i, by_halving ? 6 : 20)});
    for (const HalvingRound& round : halve(60, by_halving ? 840 : 0)) {
        const std::vector<std::size_t> order = ranking(outcomes);
        for (int i = 0; i < round.survivors; ++i) {
            const std::size_t who = order[static_cast<std::size_t>(i)];
            outcomes[who].score = pooled(outcomes[who].score, play(who, round.episodes));
        }
    }
    const std::size_t best = ranking(outcomes).front();
    return {truth[best], outcomes[best].score.mean};
}

TEST(Halving, FindsABetterWinnerWithLessOptimismForTheSameEpisodes) {
    RandomStream stream(5, "test", "halving");
    Choice even;
    Choice halved;
    constexpr int kRuns = 300;
    for (int i = 0; i < kRuns; ++i) {
        const Choice e = choose(false, stream);
        const Choice h = choose(true, stream);
        even = {even.truth + e.truth / kRuns, even.seeming + e.seeming / kRuns};
        halved = {halved.truth + h.truth / kRuns, halved.seeming + h.seeming / kRuns};
    }
    EXPECT_GT(halved.truth, even.truth + 0.04);
    EXPECT_LT(halved.seeming - halved.truth, 0.5 * (even.seeming - even.truth));
}

}  // namespace
}  // namespace k3d::optimizer::algorithm
