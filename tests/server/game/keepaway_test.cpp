// SPDX-License-Identifier: BSD-3-Clause
// Keepaway: start positions, end rules, kicks and passes, the result.
#include "server/game/keepaway/keepaway.h"

#include <gtest/gtest.h>

namespace k3d::server::game {
namespace {

body::Player& add(body::Scene& scene, wire::Side team, int unum) {
    body::Player& player = scene.add_player(0, {0, 0, 1});
    player.team = team;
    player.unum = unum;
    return player;
}

class Match : public ::testing::Test {
  protected:
    Match() {
        for (int unum = 1; unum <= 3; ++unum) add(scene, wire::Side::Left, unum);
        for (int unum = 1; unum <= 2; ++unum) add(scene, wire::Side::Right, unum);
        game.emplace(config, 5, scene);
    }
    void step() {
        game->before_step(scene);
        scene.world.step();
        game->after_step(scene);
    }
    void until_play_on() {
        for (int i = 0; i < 160 && game->state().mode != PlayMode::PlayOn; ++i) step();
        ASSERT_EQ(game->state().mode, PlayMode::PlayOn);
    }
    void put(wire::Side team, int unum, double x, double y) {
        scene.find(team, unum)->robot->place({x, y, 0.386}, 0.0);
    }
    KeepawayConfig config;
    body::Scene scene;
    std::optional<Keepaway> game;
};

TEST(Start, IsThePapersWithoutJitter) {
    KeepawayConfig config;
    config.jitter = 0.0;
    config.jitter_yaw_deg = 0.0;
    const Start start = make_start(config, RandomStream(1, "keepaway", "start"));
    ASSERT_EQ(start.keepers.size(), 3U);
    for (const Pose2& keeper : start.keepers) {
        EXPECT_NEAR(keeper.position.norm(), 2.5, 1e-12);
        EXPECT_NEAR(angle_at(keeper.position + direction(keeper.yaw), keeper.position, Vec2(0, 0)),
                    0.0, 1e-9) << "faces the centre";
    }
    EXPECT_TRUE(start.takers[0].position.isApprox(Vec2(4.7, 4.7)));
    EXPECT_TRUE(start.takers[1].position.isApprox(Vec2(4.7, -4.7)));
    // The keeper at 210 degrees is farthest from the takers.
    EXPECT_NEAR((start.ball - start.keepers[1].position).norm(), 0.3, 1e-12);
}

TEST(Start, JitterIsSeededAndBounded) {
    const KeepawayConfig config;
    const Start one = make_start(config, RandomStream(1, "keepaway", "start"));
    const Start again = make_start(config, RandomStream(1, "keepaway", "start"));
    const Start other = make_start(config, RandomStream(2, "keepaway", "start"));
    EXPECT_EQ(one.ball, again.ball);
    EXPECT_NE(one.ball, other.ball);
    EXPECT_NEAR((one.keepers[0].position - Vec2(0, 2.5)).cwiseAbs().maxCoeff(), 0.0, 0.1);
}

TEST_F(Match, PlayOnComesAfterThreeSecondsAndTheBallWaits) {
    const Vec3 ball = scene.ball.position();
    int cycles = 0;
    while (game->state().mode == PlayMode::BeforeKickOff && cycles < 200) {
        step();
        ++cycles;
    }
    EXPECT_EQ(cycles, 150);
    EXPECT_NEAR((scene.ball.position() - ball).head<2>().norm(), 0.0, 1e-6);
    EXPECT_EQ(game->state().time, 0.0) << "hold time counts from PlayOn";
}

TEST_F(Match, WhoStraysBeforeKickOffIsPutBack) {
    const Vec3 start = scene.find(wire::Side::Right, 1)->robot->torso_position();
    put(wire::Side::Right, 1, 1.0, 1.0);
    step();
    EXPECT_NEAR((scene.find(wire::Side::Right, 1)->robot->torso_position() - start).norm(), 0, 0.05);
}

TEST_F(Match, TakerAtTheBallEndsIt) {
    until_play_on();
    const Vec3 ball = scene.ball.position();
    put(wire::Side::Right, 1, ball.x() + 0.25, ball.y());
    step();
    EXPECT_FALSE(game->over());
    put(wire::Side::Right, 1, ball.x() + 0.18, ball.y());
    step();
    ASSERT_TRUE(game->over());
    const episode::Result result = game->result();
    EXPECT_EQ(result.reason, "taker_reached_ball");
    EXPECT_EQ(result.status, episode::Status::Finished);
    EXPECT_NEAR(result.hold_time_s, 0.04, 1e-9);
}

TEST_F(Match, BallOutsideEndsIt) {
    until_play_on();
    scene.ball.move({-4.99, 0, 0.042});
    scene.ball.set_velocity({-2, 0, 0});
    step();
    EXPECT_TRUE(game->over());
    EXPECT_EQ(game->result().reason, "ball_out");
}

TEST_F(Match, KeeperOutsideEndsItButTakerMayLeave) {
    until_play_on();
    put(wire::Side::Right, 2, 6, 0);
    step();
    EXPECT_FALSE(game->over());
    put(wire::Side::Left, 2, 0, 5.1);
    step();
    EXPECT_EQ(game->result().reason, "keeper_out");
}

TEST_F(Match, AbortKeepsTheFirstReason) {
    until_play_on();
    game->abort(episode::Status::AgentLost, "left.2: peer closed");
    game->abort(episode::Status::Diverged, "later");
    EXPECT_EQ(game->result().status, episode::Status::AgentLost);
    EXPECT_EQ(game->result().reason, "left.2: peer closed");
}

TEST_F(Match, FallIsCountedOnce) {
    until_play_on();
    body::Robot& robot = *scene.find(wire::Side::Left, 1)->robot;
    for (int i = 0; i < 100; ++i) {
        if (i < 20) robot.drive(nao::JointId::LAnklePitch, -1.5);
        if (i < 20) robot.drive(nao::JointId::RAnklePitch, -1.5);
        if (i == 20) robot.drive(nao::JointId::LAnklePitch, 0.0);
        if (i == 20) robot.drive(nao::JointId::RAnklePitch, 0.0);
        step();
    }
    EXPECT_EQ(game->result().players[0].falls, 1);
    EXPECT_EQ(game->result().players[1].falls, 0);
}

TEST_F(Match, WhoIsTakenOffTheFieldLeavesTheOthersFiguresAlone) {
    until_play_on();
    scene.remove_player(scene.find(wire::Side::Left, 1)->id);
    for (int i = 0; i < 60; ++i) step();
    const auto players = game->result().players;
    ASSERT_EQ(players.size(), 5U);
    for (const auto& player : players) {
        EXPECT_LT(player.distance_m, 0.1)
            << player.team << " " << player.unum << " only stood there";
    }
}

TEST(TimeLimit, Truncates) {
    KeepawayConfig config;
    config.limit = 1.0;
    body::Scene scene;
    for (int unum = 1; unum <= 3; ++unum) add(scene, wire::Side::Left, unum);
    for (int unum = 1; unum <= 2; ++unum) add(scene, wire::Side::Right, unum);
    Keepaway game(config, 1, scene);
    for (int i = 0; i < 250 && !game.over(); ++i) {
        game.before_step(scene);
        scene.world.step();
        game.after_step(scene);
    }
    EXPECT_EQ(game.result().status, episode::Status::Truncated);
    EXPECT_EQ(game.result().reason, "time_limit");
    EXPECT_NEAR(game.result().hold_time_s, 1.0, 1e-9);
}

TEST(PassCounter, KickCountsWhenTheBallHasLeft) {
    PassCounter counter;
    counter.update({1}, {}, {0, 0});
    counter.update({}, {}, {0.3, 0});
    EXPECT_EQ(counter.kicks(), 0);
    counter.update({}, {}, {0.6, 0});
    counter.update({}, {}, {0.9, 0});
    EXPECT_EQ(counter.kicks(), 1);
    counter.update({2}, {}, {2.0, 0});
    EXPECT_EQ(counter.passes(), 1);
}

TEST(PassCounter, OwnReceptionShortBallAndTakerTouchAreNoPasses) {
    PassCounter counter;
    counter.update({1}, {}, {0, 0});
    counter.update({}, {}, {0.6, 0});
    counter.update({1}, {}, {2.0, 0});  // its own ball
    EXPECT_EQ(counter.passes(), 0);
    counter.update({}, {}, {2.7, 0});
    counter.update({2}, {}, {3.0, 0});  // only 1 m
    EXPECT_EQ(counter.passes(), 0);
    counter.update({}, {}, {4.0, 0});
    counter.update({}, {9}, {4.8, 0});  // a taker in between
    counter.update({3}, {}, {6.0, 0});
    EXPECT_EQ(counter.passes(), 0);
    EXPECT_EQ(counter.kicks(), 3);
}

class LeagueMatch : public Match {
  protected:
    LeagueMatch() {
        config.rules = "league";
        game.emplace(config, 5, scene);
        until_play_on();
    }
};

TEST_F(LeagueMatch, TheBoxShrinksByFourMetresAMinute) {
    EXPECT_NEAR(game->side(), 20.0, 0.01);
    game->state().time = 60.0;
    EXPECT_NEAR(game->side(), 16.0, 1e-9);
    scene.ball.move({7.9, 0, 0.042});
    scene.ball.set_velocity(Vec3::Zero());
    step();
    EXPECT_FALSE(game->over());
    game->state().time = 63.0;
    step();
    EXPECT_EQ(game->result().reason, "ball_out");
}

TEST_F(LeagueMatch, EndsWhenATakerTouchesTheBallNotWhenItIsNear) {
    const Vec3 ball = scene.ball.position();
    put(wire::Side::Right, 1, ball.x() - 0.25, ball.y());
    step();
    EXPECT_FALSE(game->over());
    put(wire::Side::Right, 1, ball.x() - 0.13, ball.y() + 0.055);
    step();
    ASSERT_TRUE(game->over());
    EXPECT_EQ(game->result().reason, "taker_touched_ball");
}

TEST_F(LeagueMatch, KeepersMayLeaveTheBox) {
    put(wire::Side::Left, 2, 0, 12.0);
    step();
    EXPECT_FALSE(game->over());
}

}  // namespace
}  // namespace k3d::server::game
