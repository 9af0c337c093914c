// SPDX-License-Identifier: BSD-3-Clause
// Restarts of CMA-ES: IPOP doubles the population, BIPOP alternates, and both keep to the budget.
#include "optimizer/algorithm/cmaes/restarts.h"

#include <gtest/gtest.h>

#include <limits>

#include "optimizer/algorithm/functions.h"

namespace k3d::optimizer::algorithm {
namespace {

using testing::Values;

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

spec::CmaesSpec with(const std::string& restarts) {
    spec::CmaesSpec spec;
    spec.restarts = restarts;
    return spec;
}

TEST(Restarts, NoneMeansNone) {
    cmaes::Restarts state{10, 0, 0.0, 0.0, 0.0};
    RandomStream stream(1, "test", "restarts");
    EXPECT_FALSE(cmaes::next_attempt(with("none"), state, kNoLimit, stream));
}

TEST(Restarts, IpopDoublesUntilItsLimit) {
    cmaes::Restarts state{10, 0, 0.0, 0.0, 0.0};
    RandomStream stream(1, "test", "restarts");
    spec::CmaesSpec spec = with("ipop");
    spec.max_restarts = 3;
    for (const int population : {20, 40, 80}) {
        const auto attempt = cmaes::next_attempt(spec, state, kNoLimit, stream);
        ASSERT_TRUE(attempt);
        EXPECT_EQ(attempt->population, population);
        EXPECT_EQ(attempt->sigma, 1.0);
    }
    EXPECT_FALSE(cmaes::next_attempt(spec, state, kNoLimit, stream));
}

TEST(Restarts, BipopGivesTheRegimeThatUsedLessItsTurn) {
    cmaes::Restarts state{10, 0, 0.0, 0.0, 0.0};
    RandomStream stream(1, "test", "restarts");
    const spec::CmaesSpec spec = with("bipop");
    cmaes::count(state, {10, 1.0, false, 0.0}, 1000.0);
    const auto large = cmaes::next_attempt(spec, state, kNoLimit, stream);
    ASSERT_TRUE(large);
    EXPECT_FALSE(large->small);
    EXPECT_EQ(large->population, 20);
    cmaes::count(state, *large, 3000.0);
    double used = 0.0;
    while (used < 4000.0) {  // small ones until they, too, have used 4000
        const auto small = cmaes::next_attempt(spec, state, kNoLimit, stream);
        ASSERT_TRUE(small);
        EXPECT_TRUE(small->small);
        EXPECT_GE(small->population, 10);
        EXPECT_LE(small->population, 20);
        EXPECT_LE(small->sigma, 1.0);
        EXPECT_GE(small->sigma, 0.01);
        EXPECT_EQ(small->candidates, 1500.0);  // half of the last large one
        cmaes::count(state, *small, small->candidates);
        used += small->candidates;
    }
    const auto next = cmaes::next_attempt(spec, state, kNoLimit, stream);
    ASSERT_TRUE(next);
    EXPECT_EQ(next->population, 40);
}

TEST(Restarts, NoAttemptGetsMoreThanTheBudgetHolds) {
    cmaes::Restarts state{10, 0, 0.0, 0.0, 0.0};
    RandomStream stream(1, "test", "restarts");
    EXPECT_FALSE(cmaes::next_attempt(with("ipop"), state, 39.0, stream));  // not two generations of 20
    state.large_restarts = 0;
    const auto attempt = cmaes::next_attempt(with("ipop"), state, 100.0, stream);
    ASSERT_TRUE(attempt);
    EXPECT_EQ(attempt->candidates, 100.0);
}

TEST(Restarts, RosenbrockIsSolvedByEverySeedWithIpop) {
    int restarted = 0;
    for (std::uint64_t seed = 1; seed <= 15; ++seed) {
        spec::AlgorithmSpec spec;
        spec.cmaes.restarts = "ipop";
        Algorithm algorithm(spec, testing::box(10, 0.0, 0.5), seed);
        EXPECT_TRUE(testing::minimise(algorithm, testing::rosenbrock, 1e-9, 2e5).reached)
            << "seed " << seed;
        for (const auto& line : algorithm.take_log()) {
            if (line["attempt"] == 2) {
                ++restarted;
                break;
            }
        }
    }
    EXPECT_GT(restarted, 0) << "no seed met the local minimum: the test shows nothing";
}

TEST(Restarts, BipopSolvesWhatOneAttemptDoesNot) {
    const auto rastrigin = [](const Values& x) {
        double sum = 0.0;
        for (const double v : x) sum += v * v + 10.0 * (1.0 - std::cos(2.0 * 3.14159265358979 * v));
        return sum;
    };
    int alone = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        spec::AlgorithmSpec spec;
        spec::VectorProblem problem = testing::box(5, 2.2, 1.0);
        for (spec::Parameter& p : problem) p.lower = -5.0, p.upper = 5.0;
        Algorithm single(spec, problem, seed);
        alone += testing::minimise(single, rastrigin, 1e-9, 3e5).reached ? 1 : 0;
        spec.cmaes.restarts = "bipop";
        Algorithm algorithm(spec, problem, seed);
        const testing::Run run = testing::minimise(algorithm, rastrigin, 1e-9, 3e5);
        EXPECT_TRUE(run.reached) << "seed " << seed << ": " << run.reason;
    }
    EXPECT_LT(alone, 5);
}

TEST(Restarts, TheRunKeepsToItsEpisodes) {
    spec::AlgorithmSpec spec;
    spec.cmaes.restarts = "ipop";
    spec.max_episodes = 5000;
    Algorithm algorithm(spec, testing::box(5, 3.0, 1.0), 1);
    const testing::Run run = testing::minimise(algorithm, testing::sphere, -1.0, 1e6);
    EXPECT_LE(run.evaluations, 5000 + 64);
    EXPECT_EQ(static_cast<double>(algorithm.episodes_told()), run.evaluations);
    EXPECT_TRUE(algorithm.finished());
}

}  // namespace
}  // namespace k3d::optimizer::algorithm
