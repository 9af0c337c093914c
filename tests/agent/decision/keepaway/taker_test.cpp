// SPDX-License-Identifier: BSD-3-Clause
// Tests of takers: who chases, whom the others follow, and that they pick anew only on a pass.
#include "agent/decision/keepaway/taker.h"

#include <gtest/gtest.h>

#include <set>

#include "agent/decision/keepaway/scene.h"

namespace k3d::agent::decision {
namespace {

using test::player;
using test::scene;

const Vec2 kKeepers[] = {{0.0, 2.5}, {-2.0, -1.5}, {2.0, -1.5}};

/// Taker 2 far from the ball, taker 1 near it; keeper 1 has the ball.
world::Beliefs follower(double now, Vec2 ball = {0.0, 2.3}) {
    world::Beliefs b = scene(2, {{4.5, 4.5}, kPi}, ball, now);
    b.mates = {player(1, true, {1.0, 2.0})};
    for (int i = 0; i < 3; ++i) b.opponents.push_back(player(i + 1, false, kKeepers[i]));
    return b;
}

Taker taker(const std::string& strategy, std::uint64_t seed) {
    TakerConfig config;
    config.strategy = strategy;
    return {config, skills::SkillConfig{}, RandomStream(seed, "right.2", "follow")};
}

TEST(Taker, GreedyOnesAllWalkOntoTheBall) {
    Taker t = taker("greedy", 1);
    const Decision d = t.decide(follower(10.0), {});
    EXPECT_EQ(d.account.role, "chaser");
    EXPECT_TRUE(test::is_walk(d.request.body));
    EXPECT_FALSE(d.say);
}

TEST(Taker, OnlyTheClosestChases) {
    Taker t = taker("greedy_random", 1);
    EXPECT_EQ(t.decide(follower(10.0), {}).account.role, "follower");
    world::Beliefs b = follower(10.1);
    b.mates[0].position = {-4.5, -4.5};
    b.self.pose.position = {1.0, 2.0};
    EXPECT_EQ(t.decide(b, {}).account.role, "chaser");
}

TEST(Taker, NeitherGivesWayToTheOther) {
    // Equally far: exactly one of the two takers chases, whichever asks.
    for (const double offset : {-0.05, 0.0, 0.05}) {
        world::Beliefs one = follower(10.0, {0.0, 0.0});
        one.game.unum = 1;
        one.self.pose.position = {2.0 + offset, 0.0};
        one.mates = {player(2, true, {-2.0, 0.0})};
        world::Beliefs two = one;
        two.game.unum = 2;
        two.self.pose.position = {-2.0, 0.0};
        two.mates = {player(1, true, {2.0 + offset, 0.0})};
        Taker a = taker("greedy_random", 1);
        Taker b = taker("greedy_random", 2);
        const bool first = a.decide(one, {}).account.role == "chaser";
        const bool second = b.decide(two, {}).account.role == "chaser";
        EXPECT_NE(first, second) << offset;
    }
}

TEST(Taker, FollowsAKeeperOtherThanK1EachSometimes) {
    std::set<int> followed;
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        Taker t = taker("greedy_random", seed);
        t.decide(follower(10.0), {});
        followed.insert(t.followed());
    }
    EXPECT_EQ(followed, (std::set<int>{2, 3}));
}

TEST(Taker, PicksANewKeeperOnlyWhenAPassIsMade) {
    int changed = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Taker t = taker("greedy_random", seed);
        double now = 10.0;
        t.decide(follower(now), {});
        const int first = t.followed();

        // Ten seconds of play without a pass: keepers move about, K1 moves the ball a little, other
        // keepers come nearer to it, one is out of sight for a while.
        for (int cycle = 0; cycle < 500; ++cycle) {
            now += 0.02;
            world::Beliefs b = follower(now, {0.2 * std::sin(now), 2.3});
            b.opponents[1].position += Vec2(std::cos(now), std::sin(now));
            if (cycle > 200 && cycle < 300) b.opponents[1].position = {0.0, 2.2};
            if (cycle > 350 && cycle < 400) b.opponents.erase(b.opponents.begin());
            t.decide(b, {});
            ASSERT_EQ(t.followed(), first) << "seed " << seed << " cycle " << cycle;
        }

        // Keeper 1 passes to keeper 2: the finish jumps there; soon after a new keeper is drawn,
        // once, and never the new K1.
        for (int cycle = 0; cycle < 100; ++cycle) {
            now += 0.02;
            world::Beliefs b = follower(now, {-0.5, 1.0});
            b.ball.moving = true;
            b.ball.finish = {-2.0, -1.3};
            t.decide(b, {});
            if (cycle == 15) {
                EXPECT_NE(t.followed(), 2);
                changed += t.followed() != first;
            }
        }
        const int second = t.followed();
        EXPECT_NE(second, 2);
        for (int cycle = 0; cycle < 100; ++cycle) {
            now += 0.02;
            t.decide(follower(now, {-2.0, -1.3}), {});
            ASSERT_EQ(t.followed(), second);
        }
    }
    EXPECT_GE(changed, 5);
}

TEST(Taker, StopsShortOfTheKeeperItFollows) {
    Taker t = taker("greedy_random", 3);
    world::Beliefs b = follower(10.0);
    t.decide(b, {});
    const Vec2 keeper = kKeepers[t.followed() - 1];
    b.self.pose = {keeper + Vec2(0.6, 0.0), yaw_of(b.ball.position - keeper - Vec2(0.6, 0.0))};
    EXPECT_TRUE(test::is_stand(t.decide(b, {}).request.body));
}

}  // namespace
}  // namespace k3d::agent::decision
