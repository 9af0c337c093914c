// SPDX-License-Identifier: BSD-3-Clause
// What a drilling robot asks of its body.
#include "agent/decision/drill/drill.h"

#include <gtest/gtest.h>

#include "agent/decision/keepaway/scene.h"

namespace k3d::agent::decision {
namespace {

Drill drill(const DrillConfig& config, std::uint64_t seed = 1) {
    return {config, {}, {}, test::simple_kick(), RandomStream(seed, "left.1", "drill")};
}

TEST(Drill, WalksAsToldEvenWithoutAPose) {
    DrillConfig config;
    config.task = "walk";
    config.left = -0.2;
    Drill d = drill(config);
    world::Beliefs b = test::scene(1, {}, {1.0, 0.0});
    b.self.localised = false;
    const auto request = d.decide(b, {}).request.body;
    ASSERT_TRUE(test::is_walk(request));
    EXPECT_EQ(std::get<motion::Walk>(request).left, -0.2);
}

TEST(Drill, GoesToATargetOfTheAreaAndOnToTheNextInTime) {
    DrillConfig config;
    config.task = "go_to";
    config.centre_x = -5.0;
    config.half_area = 2.0;
    config.shortest = config.longest = 3.0;
    Drill d = drill(config);
    world::Beliefs b = test::scene(1, {{-5.0, 0.0}, 0.0}, {10.0, 0.0});
    const Vec2 first = *d.decide(b, {}).account.target;
    EXPECT_LE(std::abs(first.x() + 5.0), 2.0);
    EXPECT_LE(std::abs(first.y()), 2.0);
    b.now += 2.9;
    EXPECT_EQ(*d.decide(b, {}).account.target, first);
    b.now += 0.2;
    EXPECT_NE(*d.decide(b, {}).account.target, first);
    EXPECT_EQ(*drill(config).decide(b, {}).account.target, first) << "the same seed, the same way";
    EXPECT_NE(*drill(config, 2).decide(b, {}).account.target, first);
}

TEST(Drill, KicksOnce) {
    DrillConfig config;
    config.task = "kick";
    config.target_x = 5.0;
    Drill d = drill(config);
    const world::Beliefs b = test::scene(1, {{-0.2, 0.0}, 0.0}, {0.0, 0.0});
    motion::State body;
    d.decide(b, body);
    Decision decision = d.decide(b, body);
    ASSERT_TRUE(test::is_kick(decision.request.body));
    EXPECT_NEAR(std::get<motion::Kick>(decision.request.body).distance, 5.0, 1e-9);
    body.activity = motion::Activity::Kicking;
    EXPECT_TRUE(test::is_kick(d.decide(b, body).request.body));
    body.activity = motion::Activity::Standing;
    body.kick_done = true;
    EXPECT_TRUE(test::is_stand(d.decide(b, body).request.body));
    body.kick_done = false;
    EXPECT_TRUE(test::is_stand(d.decide(b, body).request.body));
}

TEST(Drill, WhoIsToPossessDoesNotKick) {
    DrillConfig config;
    config.task = "possess";
    config.target_x = 5.0;
    Drill d = drill(config);
    const world::Beliefs b = test::scene(1, {{-0.2, 0.0}, 0.0}, {0.0, 0.0});
    for (int i = 0; i < 5; ++i) EXPECT_FALSE(test::is_kick(d.decide(b, {}).request.body));
}

TEST(Drill, FallsOnceTheWayItIsTold) {
    DrillConfig config;
    config.task = "get_up";
    config.fall = "back";
    Drill d = drill(config);
    const world::Beliefs b = test::scene(1, {}, {1.0, 0.0});
    motion::State body;
    const auto request = d.decide(b, body).request.body;
    ASSERT_TRUE(std::holds_alternative<motion::Topple>(request));
    EXPECT_LT(std::get<motion::Topple>(request).forward, 0.0);
    body.falls = 1;
    EXPECT_TRUE(test::is_stand(d.decide(b, body).request.body));
}

}  // namespace
}  // namespace k3d::agent::decision
