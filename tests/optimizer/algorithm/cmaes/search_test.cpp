// SPDX-License-Identifier: BSD-3-Clause
// Tests of optimizer/algorithm/cmaes/search: scales, noise handling, the estimator.
#include "optimizer/algorithm/cmaes/search.h"

#include <gtest/gtest.h>

#include "optimizer/algorithm/functions.h"

namespace k3d::optimizer::algorithm {
namespace {

using testing::Values;

TEST(CmaesSearch, ScalesOfParametersDoNotMatter) {
    spec::VectorProblem problem = testing::box(6, 1.0, 1.0);
    for (std::size_t i = 0; i < 6; ++i) {
        problem[i].start = std::pow(10.0, static_cast<double>(i) - 3.0);
        problem[i].deviation = problem[i].start;
    }
    Algorithm algorithm({}, problem, 4);
    const testing::Run run = testing::minimise(
        algorithm,
        [&problem](Values x) {
            for (std::size_t i = 0; i < 6; ++i) x[i] /= problem[i].deviation;
            return testing::sphere(x);
        },
        1e-9, 1e5);
    EXPECT_TRUE(run.reached);
    EXPECT_LT(run.evaluations, 1500.0);
}

TEST(CmaesSearch, NoiseCallsForEpisodesAndClearRanksForNone) {
    spec::AlgorithmSpec spec;
    spec.sampling.episodes = 4;
    spec.cmaes.noise = "reevaluate";
    spec.cmaes.max_episodes = 20;
    const cmaes::Search search(spec, Coordinates(testing::box(5, 0.0, 1.0)), 1, 1e9);
    std::vector<Outcome> clear;
    std::vector<Outcome> noisy;
    for (std::size_t i = 0; i < search.size(); ++i) {
        clear.push_back({false, {static_cast<double>(i), 0.1, 4}});
        noisy.push_back({false, {static_cast<double>(i), 5.0, 4}});
    }
    EXPECT_EQ(search.episodes_wanted(clear), 4);
    EXPECT_EQ(search.episodes_wanted(noisy), 6);
    for (Outcome& outcome : noisy) outcome.score.n = 18;
    EXPECT_EQ(search.episodes_wanted(noisy), 20);
    for (Outcome& outcome : noisy) outcome.score.n = 20;
    EXPECT_EQ(search.episodes_wanted(noisy), 20);
}

TEST(CmaesSearch, TheMeanIsNearerTheOptimumThanTheLuckiestSample) {
    // Constant noise far above what is left to gain near the optimum.
    spec::AlgorithmSpec spec;
    spec.sampling.episodes = 2;
    spec.cmaes.noise = "reevaluate";
    spec.cmaes.max_episodes = 8;
    spec.sampling.validation_episodes = 50;
    spec.max_generations = 80;
    Algorithm algorithm(spec, testing::box(6, 2.0, 1.0), 3);
    RandomStream noise(1, "test", "noise");
    double luckiest = -1e9;
    double lucky_truth = 0.0;
    while (!algorithm.finished()) {
        for (const Request& request : algorithm.ask()) {
            const double truth = -testing::sphere(std::get<Values>(request.payload));
            std::vector<double> values;
            for (int i = 0; i < request.episodes; ++i) values.push_back(truth + 2.0 * noise.normal());
            const Score score = score_of(values);
            algorithm.tell(request.candidate, request.pool, score);
            if (request.pool == Pool::Train && score.mean > luckiest) {
                luckiest = score.mean;
                lucky_truth = truth;
            }
        }
        algorithm.advance();
    }
    ASSERT_TRUE(algorithm.champion());
    const double champion = -testing::sphere(std::get<Values>(algorithm.champion()->payload));
    EXPECT_GT(champion, lucky_truth);
    EXPECT_GT(champion, -1.0);
}

}  // namespace
}  // namespace k3d::optimizer::algorithm
