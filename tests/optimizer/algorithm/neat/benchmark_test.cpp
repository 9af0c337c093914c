// SPDX-License-Identifier: BSD-3-Clause
// NEAT on the benchmarks of its paper: XOR (published mean: 32 generations of 150) and two poles with
// velocities (published mean: 3,578 evaluations). These take seconds: 100 and 30 seeds each.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "optimizer/algorithm/functions.h"
#include "optimizer/algorithm/neat/double_pole.h"
#include "optimizer/algorithm/neat/search.h"
#include "optimizer/algorithm/neat/tasks.h"

namespace k3d::optimizer::algorithm::neat {
namespace {

Settings profile(const std::string& name) {
    spec::NeatSpec spec;
    spec.profile = name;
    spec.population = 150;
    return settings_of(spec);
}

struct Solved {
    int generations = 0;  ///< up to and with the one that solved it; 0: none did
    int hidden = 0;       ///< of the first solution
};

Solved solve_xor(const Settings& settings, std::uint64_t seed, int most) {
    Search search(settings, testing::empty_network(2, 1), seed);
    for (int generation = 0; generation < most; ++generation) {
        search.begin(generation);
        std::vector<Outcome> outcomes;
        for (std::size_t i = 0; i < search.size(); ++i) {
            const testing::Xor played = testing::play_xor(search.network(i));
            if (played.solved) return {generation + 1, search.population()[i].hidden()};
            outcomes.push_back({false, {played.fitness, 0.0, 1}});
        }
        search.update(outcomes);
    }
    return {};
}

void expect_xor(const std::string& name, double most_generations) {
    constexpr int kSeeds = 100;
    double generations = 0.0;
    double hidden = 0.0;
    int worst = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Solved solved = solve_xor(profile(name), seed, 300);
        EXPECT_GT(solved.generations, 0) << "seed " << seed << " is not solved in 300 generations";
        EXPECT_GE(solved.hidden, 1) << "XOR without a hidden node cannot be: seed " << seed;
        generations += solved.generations;
        hidden += solved.hidden;
        worst = std::max(worst, solved.generations);
    }
    std::cout << "XOR, " << name << ": mean " << generations / kSeeds << " generations, worst " << worst
              << ", mean hidden nodes " << hidden / kSeeds << "\n";
    EXPECT_LE(generations / kSeeds, most_generations);
    EXPECT_LE(hidden / kSeeds, 4.0);
}

TEST(NeatBenchmark, XorStanley2002) { expect_xor("stanley2002", 45.0); }

TEST(NeatBenchmark, XorModern) { expect_xor("modern", 60.0); }

TEST(NeatBenchmark, WithoutNewNodesXorIsNotSolved) {
    Settings settings = profile("stanley2002");
    settings.add_node = 0.0;
    EXPECT_EQ(solve_xor(settings, 1, 30).generations, 0);
}

/// Evaluations until a network balances both poles for 100,000 steps.
double solve_poles(const Settings& settings, std::uint64_t seed) {
    Search search(settings, testing::empty_network(6, 1), seed);
    double evaluations = 0.0;
    for (int generation = 0; generation < 200; ++generation) {
        search.begin(generation);
        std::vector<Outcome> outcomes;
        for (std::size_t i = 0; i < search.size(); ++i) {
            const network::Network net(search.network(i), "genome");
            const testing::Balance b = testing::balance(net, testing::usual_start(), true, 100000);
            evaluations += 1.0;
            if (b.steps == 100000) return evaluations;
            outcomes.push_back({false, {static_cast<double>(b.steps), 0.0, 1}});
        }
        search.update(outcomes);
    }
    return evaluations;
}

TEST(NeatBenchmark, TwoPolesWithVelocities) {
    std::vector<double> evaluations;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        evaluations.push_back(solve_poles(profile("stanley2002"), seed));
    }
    std::cout << "two poles with velocities: median " << testing::median(evaluations)
              << " evaluations, worst " << *std::max_element(evaluations.begin(), evaluations.end())
              << "\n";
    EXPECT_LE(testing::median(evaluations), 6000.0);
}

TEST(DoublePole, PhysicsIsSound) {
    // Nobody pushes: the long pole falls to the side it leans to, the cart moves the other way.
    testing::PoleState s = testing::usual_start();
    for (int i = 0; i < 20; ++i) s = testing::push_cart(s, 0.0);
    EXPECT_GT(s[2], testing::usual_start()[2]);
    EXPECT_LT(s[0], 0.0);
    // Mirrored states stay mirrored, and upright ones upright.
    testing::PoleState mirror{};
    for (std::size_t i = 0; i < 6; ++i) mirror[i] = -testing::usual_start()[i];
    for (int i = 0; i < 20; ++i) mirror = testing::push_cart(mirror, 0.0);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(mirror[i], -s[i], 1e-12);
    const testing::PoleState upright{};
    EXPECT_EQ(testing::push_cart(upright, 0.0), upright);
    EXPECT_LT(testing::push_cart(upright, 10.0)[2], 0.0) << "the cart leaves the pole behind";
}

}  // namespace
}  // namespace k3d::optimizer::algorithm::neat
