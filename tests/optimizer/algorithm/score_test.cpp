// SPDX-License-Identifier: BSD-3-Clause
// Tests of optimizer/algorithm/score: pooling, ranking, and how much of a spread is noise.
#include "optimizer/algorithm/score.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/random/stream.h"

namespace k3d::optimizer::algorithm {
namespace {

TEST(Score, MeanAndStandardError) {
    const Score score = score_of({1.0, 2.0, 3.0, 6.0});
    EXPECT_DOUBLE_EQ(score.mean, 3.0);
    EXPECT_DOUBLE_EQ(score.se, std::sqrt(14.0 / 3.0 / 4.0));
    EXPECT_EQ(score.n, 4);
    EXPECT_EQ(score_of({5.0}), (Score{5.0, 0.0, 1}));
}

TEST(Ranking, BestFirstFailedLastEqualsInOrderOfBirth) {
    const std::vector<Outcome> outcomes = {{true, {}},
                                           {false, {1.0, 0.0, 1}},
                                           {false, {3.0, 0.0, 1}},
                                           {false, {1.0, 0.0, 1}},
                                           {true, {9.0, 0.0, 1}}};
    EXPECT_EQ(ranking(outcomes), (std::vector<std::size_t>{2, 1, 3, 0, 4}));
}

TEST(Reliability, SeparatesSpreadFromNoise) {
    RandomStream stream(1, "test", "reliability");
    // True spread 2, standard error 1: four fifths of the variance is signal.
    std::vector<Outcome> outcomes;
    for (int i = 0; i < 20000; ++i) {
        const double truth = 2.0 * stream.normal();
        outcomes.push_back({false, {truth + stream.normal(), 1.0, 4}});
    }
    outcomes.push_back({true, {1e9, 0.0, 1}});  // a failed one counts for nothing
    EXPECT_NEAR(reliability(outcomes), 0.8, 0.02);
    for (Outcome& outcome : outcomes) outcome.score.se = 0.0;
    EXPECT_EQ(reliability(outcomes), 1.0);
    for (Outcome& outcome : outcomes) outcome.score.se = 50.0;
    EXPECT_EQ(reliability(outcomes), 0.0);
}

}  // namespace
}  // namespace k3d::optimizer::algorithm
