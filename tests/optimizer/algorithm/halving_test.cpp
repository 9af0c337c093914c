// SPDX-License-Identifier: BSD-3-Clause
// Tests of optimizer/algorithm/halving: rounds, their cost, and what they are good for.
#include "optimizer/algorithm/halving.h"

#include <gtest/gtest.h>

#include "common/random/stream.h"
#include "optimizer/algorithm/algorithm.h"
#include "optimizer/algorithm/functions.h"

namespace k3d::optimizer::algorithm {
namespace {

TEST(Halving, SharesTheBudgetOverItsRounds) {
    EXPECT_EQ(halve(16, 48), (std::vector<HalvingRound>{{8, 2}, {4, 4}, {2, 8}}));
    EXPECT_EQ(halve(60, 0), std::vector<HalvingRound>{});
    EXPECT_EQ(halve(2, 100), std::vector<HalvingRound>{});
    EXPECT_EQ(halve(3, 10), (std::vector<HalvingRound>{{2, 5}}));
    EXPECT_EQ(halve(16, 3), (std::vector<HalvingRound>{{8, 1}, {4, 1}, {2, 1}}));
}

TEST(Finals, TheWinnerHasAllEpisodes) {
    EXPECT_EQ(finals(4, 100), (std::vector<HalvingRound>{{4, 25}, {2, 50}, {1, 100}}));
    EXPECT_EQ(finals(1, 100), (std::vector<HalvingRound>{{1, 100}}));
    EXPECT_EQ(finals(5, 8), (std::vector<HalvingRound>{{5, 1}, {3, 2}, {2, 4}, {1, 8}}));
}

/// The champion of a generation of 60 candidates whose true means spread by 0.2 about 3.1, with noise
/// of 1.29 an episode and 1,200 episodes in all: its true mean, and what that seemed to be.
struct Choice {
    double truth = 0.0;
    double seeming = 0.0;
};

spec::AlgorithmSpec one_generation(bool by_halving) {
    spec::AlgorithmSpec spec;
    spec.name = "random_search";
    spec.max_generations = 1;
    spec.random_search.population = 60;
    spec.sampling.episodes = by_halving ? 6 : 20;
    spec.sampling.halving_episodes = by_halving ? 840 : 0;
    spec.sampling.validation_episodes = 0;
    return spec;
}

Choice choose(bool by_halving, RandomStream& stream) {
    std::vector<double> truth(60);
    for (double& t : truth) t = 3.1 + 0.2 * stream.normal();
    std::vector<std::vector<double>> played(60);
    Algorithm algorithm(one_generation(by_halving), testing::box(1, 0.0, 1.0), 1);
    while (!algorithm.finished()) {
        for (const Request& request : algorithm.ask()) {
            std::vector<double>& values = played[request.candidate];
            while (static_cast<int>(values.size()) < request.episodes) {
                values.push_back(truth[request.candidate] + 1.29 * stream.normal());
            }
            algorithm.tell(request.candidate, request.pool, score_of(values));
        }
        algorithm.advance();
    }
    EXPECT_LE(algorithm.episodes_told(), 1200U);
    const Champion champion = algorithm.champion().value();
    return {truth[champion.candidate], champion.score.mean};
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
