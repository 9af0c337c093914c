// SPDX-License-Identifier: BSD-3-Clause
// Tests of optimizer/algorithm/seeds: pools do not overlap, generations get new scenarios.
#include "optimizer/algorithm/seeds.h"

#include <gtest/gtest.h>

#include <set>

namespace k3d::optimizer::algorithm {
namespace {

TEST(Seeds, AreAllDifferentAndExactInJson) {
    std::set<std::uint64_t> seen;
    std::size_t count = 0;
    const auto add = [&](Pool pool, int generation, int index) {
        const std::uint64_t seed = scenario_seed(42, pool, generation, index);
        EXPECT_LT(seed, std::uint64_t{1} << 53);
        seen.insert(seed);
        ++count;
    };
    for (int generation = 0; generation < 300; ++generation) {
        for (int index = 0; index < 100; ++index) add(Pool::Train, generation, index);
    }
    for (int index = 0; index < 20000; ++index) add(Pool::Validation, 0, index);
    for (int index = 0; index < 20000; ++index) add(Pool::Test, 0, index);
    EXPECT_EQ(seen.size(), count);
}

TEST(Seeds, ThePoolIsInTheSeed) {
    // Whatever the run, generation and index: these can never be equal.
    for (std::uint64_t run = 0; run < 1000; ++run) {
        EXPECT_EQ(scenario_seed(run, Pool::Train, 3, 5) >> 51U, 0u);
        EXPECT_EQ(scenario_seed(run, Pool::Validation, 3, 5) >> 51U, 1u);
        EXPECT_EQ(scenario_seed(run, Pool::Test, 3, 5) >> 51U, 2u);
    }
}

TEST(Seeds, TrainingChangesByGenerationTheOthersDoNot) {
    EXPECT_NE(scenario_seed(1, Pool::Train, 0, 0), scenario_seed(1, Pool::Train, 1, 0));
    EXPECT_EQ(scenario_seed(1, Pool::Validation, 0, 0), scenario_seed(1, Pool::Validation, 9, 0));
    EXPECT_EQ(scenario_seed(1, Pool::Test, 0, 0), scenario_seed(1, Pool::Test, 9, 0));
    EXPECT_NE(scenario_seed(1, Pool::Test, 0, 0), scenario_seed(2, Pool::Test, 0, 0));
}

TEST(Seeds, TheLastOneOfARunIsStillItsOwn) {
    EXPECT_NE(scenario_seed(1, Pool::Train, 1000000, kMaxEpisodes - 1),
              scenario_seed(1, Pool::Train, 1000001, 0));
}

}  // namespace
}  // namespace k3d::optimizer::algorithm
