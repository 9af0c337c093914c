// SPDX-License-Identifier: BSD-3-Clause
// Tests of getting possession: the six variables by hand, the rules, the network from a file.
#include "agent/decision/possession.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

#include "agent/decision/keepaway/scene.h"

namespace k3d::agent::decision {
namespace {

using test::scene;

RandomStream chances(std::uint64_t seed) {
    return {seed, "test", "possession"};
}

TEST(Possession, VariablesByHand) {
    world::Beliefs b = scene(1, {{0.0, 0.0}, kPi / 2.0}, {3.0, 0.0});
    b.ball.finish = {0.0, 4.0};
    b.ball.position_before = {4.0, 3.0};
    const motion::State body;
    const PossessionInput in{.beliefs = b, .body = body, .target = {-2.0, 0.0}, .robots = {}};
    const PossessionVariables v = possession_variables(in);
    EXPECT_NEAR(v[0], 3.0, 1e-12);
    EXPECT_NEAR(v[1], 4.0, 1e-12);
    EXPECT_NEAR(v[2], 5.0, 1e-12);
    EXPECT_NEAR(v[3], 90.0, 1e-9);
    EXPECT_NEAR(v[4], 90.0, 1e-9);  // heading +y, target at -x
    EXPECT_NEAR(v[5], 3.0 - 5.0, 1e-12);
}

TEST(Possession, Rules) {
    const PossessionConfig c;
    const auto choose = [&](const PossessionVariables& v, int state = kGoToFinish) {
        return choose_by_rules(v, state, c);
    };
    EXPECT_EQ(choose({3.0, 3.0, 0.0, 0.0, 0.0, 0.0}), kGoToFinish);     // at rest, far
    EXPECT_EQ(choose({0.6, 0.6, 0.0, 0.0, 0.0, 0.0}), kPosition);       // at rest, near
    EXPECT_EQ(choose({4.0, 0.6, 4.0, 10.0, 0.0, -1.0}), kPosition);     // will come to rest here
    EXPECT_EQ(choose({0.3, 0.6, 0.9, 10.0, 0.0, -1.0}), kHold);         // arrives at the feet
    EXPECT_EQ(choose({0.3, 0.6, 0.9, 10.0, 0.0, 1.0}), kPosition);      // has passed
    EXPECT_EQ(choose({2.0, 3.0, 4.0, 110.0, 0.0, -1.0}), kIntercept);   // passes by
    EXPECT_EQ(choose({4.0, 2.0, 2.5, 20.0, 0.0, -1.0}), kGoToFinish);   // stops short of here
    EXPECT_EQ(choose({1.6, 1.6, 0.0, 0.0, 0.0, 0.0}, kPosition), kPosition);  // room for noise
    EXPECT_EQ(choose({1.6, 1.6, 0.0, 0.0, 0.0, 0.0}), kGoToFinish);
}

TEST(Possession, GoesFromFinishToPosition) {
    PossessionBehaviour b =
        make_possession({}, skills::SkillConfig{}, test::simple_kick(), chances(1));
    const motion::State body;
    const world::Beliefs far = scene(1, {{-3.0, 0.0}, 0.0}, {0.0, 0.0});
    const world::Beliefs near = scene(1, {{-0.5, 0.0}, 0.0}, {0.0, 0.0});
    const auto step = [&](const world::Beliefs& beliefs) {
        return b.get_skill({.beliefs = beliefs, .body = body, .target = {4.0, 0.0}, .robots = {}});
    };
    b.invoke();
    EXPECT_TRUE(test::is_walk(step(far)));
    EXPECT_EQ(b.state_name(), "go_to_finish");
    step(near);
    step(near);
    EXPECT_EQ(b.state_name(), "position");
}

TEST(Possession, NetworkFromAFileChooses) {
    // Outputs: hold is always largest.
    network::Definition d;
    for (const auto name : kPossessionInputs) d.inputs.push_back({std::string(name)});
    for (const char* name : {"intercept", "go_to_finish", "position", "hold"}) {
        d.outputs.emplace_back(name);
        d.nodes.push_back({name, network::Activation::Linear, std::string(name) == "hold" ? 1.0 : 0.0});
    }
    const auto path = (std::filesystem::path(testing::TempDir()) / ("k3d_possession_" + std::to_string(getpid()) + ".json"))
                          .string();
    std::ofstream(path) << network::to_json(d);
    PossessionConfig config;
    config.network = path;
    PossessionBehaviour b =
        make_possession(config, skills::SkillConfig{}, test::simple_kick(), chances(1));
    const motion::State body;
    const world::Beliefs far = scene(1, {{-3.0, 0.0}, 0.0}, {0.0, 0.0});
    b.get_skill({.beliefs = far, .body = body, .robots = {}});
    EXPECT_TRUE(test::is_stand(b.get_skill({.beliefs = far, .body = body, .robots = {}})));
    EXPECT_EQ(b.state(), kHold);

    std::swap(d.outputs.front(), d.outputs.back());
    std::ofstream(path) << network::to_json(d);
    EXPECT_THROW(make_possession(config, skills::SkillConfig{}, test::simple_kick(), chances(1)),
                 network::NetworkError);
    d.outputs.pop_back();
    std::ofstream(path) << network::to_json(d);
    EXPECT_THROW(make_possession(config, skills::SkillConfig{}, test::simple_kick(), chances(1)),
                 network::NetworkError);
    std::filesystem::remove(path);
    EXPECT_THROW(make_possession(config, skills::SkillConfig{}, test::simple_kick(), chances(1)),
                 network::NetworkError);
}

TEST(Possession, StraightTakesTheBallForOneThatLies) {
    PossessionConfig config;
    config.chooser = "straight";
    const auto first_step = [&](const PossessionConfig& c) {
        // The ball rolls away to the left; it will stop far off to the side.
        world::Beliefs b = scene(1, {{-3.0, 0.0}, 0.0}, {0.0, 0.0});
        b.ball.moving = true;
        b.ball.velocity = {0.0, 4.0};
        b.ball.finish = {0.0, 4.0};
        PossessionBehaviour behaviour =
            make_possession(c, skills::SkillConfig{}, test::simple_kick(), chances(1));
        const motion::State body;
        const PossessionInput in{.beliefs = b, .body = body, .target = {4.0, 0.0}, .robots = {}};
        behaviour.get_skill(in);
        return std::get<motion::Walk>(behaviour.get_skill(in));
    };
    EXPECT_LT(std::abs(first_step(config).turn), 0.2) << "straight on";
    EXPECT_GT(first_step({}).turn, 0.2) << "the rules look ahead";
}

/// States of "random" over 50 s, far from the ball.
std::vector<int> states_by_chance(std::uint64_t seed) {
    PossessionConfig config;
    config.chooser = "random";
    PossessionBehaviour b =
        make_possession(config, skills::SkillConfig{}, test::simple_kick(), chances(seed));
    const motion::State body;
    world::Beliefs far = scene(1, {{-3.0, 0.0}, 0.0}, {0.0, 0.0});
    std::vector<int> states;
    for (int i = 0; i < 100; ++i) {
        far.now += 0.5;
        b.get_skill({.beliefs = far, .body = body, .target = {4.0, 0.0}, .robots = {}});
        states.push_back(b.state());
    }
    return states;
}

TEST(Possession, ChanceTriesEveryStateAndFollowsItsSeed) {
    const std::vector<int> states = states_by_chance(1);
    for (int state = 0; state < static_cast<int>(kPossessionStates); ++state) {
        EXPECT_GT(std::count(states.begin(), states.end(), state), 5) << state;
    }
    EXPECT_EQ(states_by_chance(1), states);
    EXPECT_NE(states_by_chance(2), states);
}

}  // namespace
}  // namespace k3d::agent::decision
