// SPDX-License-Identifier: BSD-3-Clause
// Soccer: clock, halves, kick-off, goals, and that a lone robot in training is left alone.
#include "server/game/soccer/soccer.h"

#include "server/game/soccer/match_rig.h"

namespace k3d::server::game {
namespace {

using wire::Side;

TEST_F(SoccerRig, BeforeKickOffTheBallIsCentredTheClockStandsAndHalvesAreKept) {
    scene.ball.move({3, 2, 0.5});
    put(player(Side::Left, 1), 4.0, 0.0);
    put(player(Side::Right, 1), -4.0, 0.0);
    seconds(1.0);
    EXPECT_NEAR(scene.ball.position().head<2>().norm(), 0.0, 1e-3);
    EXPECT_EQ(game.state().time, 0.0);
    EXPECT_LT(player(Side::Left, 1).robot->torso_position().x(), -2.0);
    EXPECT_GT(player(Side::Right, 1).robot->torso_position().x(), 2.0);
    EXPECT_TRUE(game.beam_allowed());
}

TEST_F(SoccerRig, NewPlayersStandInOrderOfComingWhateverTheirNumber) {
    // As the reference server was seen to place the numbers 9, 1, 2 of one team and 7, 3 of the other.
    for (const double y : {9.2, 8.0, 6.8}) {
        const Vec3 slot = game.next_start_slot(Side::Left);
        EXPECT_NEAR((slot - Vec3(-14.2, y, 0.4)).norm(), 0.0, 1e-9) << slot.transpose();
    }
    for (const double y : {9.2, 8.0}) {
        const Vec3 slot = game.next_start_slot(Side::Right);
        EXPECT_NEAR((slot - Vec3(14.2, y, 0.4)).norm(), 0.0, 1e-9) << slot.transpose();
    }
    for (int again = 0; again < 1000; ++again) {
        EXPECT_LT(std::abs(game.next_start_slot(Side::Left).x()), 15.0);
        EXPECT_LT(std::abs(game.next_start_slot(Side::Right).x()), 15.5);
    }
}

TEST_F(SoccerRig, KickOffBecomesPlayOnWithTheFirstTouch) {
    game.kick_off(Side::Left);
    step(10);
    EXPECT_EQ(mode(), PlayMode::KickOffLeft);
    EXPECT_FALSE(game.beam_allowed());
    EXPECT_NEAR(game.state().time, 0.2, 1e-9);
    touch(Side::Left, 1);
    EXPECT_EQ(mode(), PlayMode::PlayOn);
}

TEST_F(SoccerRig, KickOffKeepsTheOthersOutOfTheCircle) {
    game.kick_off(Side::Right);
    put(player(Side::Left, 1), -1.0, 0.5);
    put(player(Side::Right, 1), -0.5, 0.0);  // across the line, within the circle: allowed
    step(2);
    EXPECT_GE(player(Side::Left, 1).robot->torso_position().head<2>().norm(), 2.0);
    EXPECT_NEAR(player(Side::Right, 1).robot->torso_position().x(), -0.5, 0.05);
}

TEST_F(SoccerRig, KickOffThatNobodyTakesIsDropped) {
    game.kick_off(Side::Left);
    put(player(Side::Left, 1), -1.0, 0.0);
    seconds(15.1);
    EXPECT_EQ(mode(), PlayMode::PlayOn);
    EXPECT_GE(player(Side::Left, 1).robot->torso_position().head<2>().norm(), 2.0);
}

TEST_F(SoccerRig, AutomaticKickOffWaitsAndGivesEachTeamAHalf) {
    config.automatic_kick_off = true;
    config.kick_off_wait = 2.0;
    config.half_time = 5.0;
    game = Soccer(config);
    seconds(1.9);
    EXPECT_EQ(mode(), PlayMode::BeforeKickOff);
    seconds(0.2);
    EXPECT_EQ(mode(), PlayMode::KickOffLeft);
    seconds(5.0);
    EXPECT_EQ(mode(), PlayMode::BeforeKickOff);
    EXPECT_EQ(game.state().half, 2);
    seconds(2.1);
    EXPECT_EQ(mode(), PlayMode::KickOffRight);
    seconds(5.1);
    EXPECT_EQ(mode(), PlayMode::GameOver);
    EXPECT_FALSE(game.over()) << "the server stays, as the reference does";
    const double end = game.state().time;
    seconds(1.0);
    EXPECT_EQ(game.state().time, end);
}

TEST_F(SoccerRig, EndsWhenAskedTo) {
    config.ends = true;
    config.half_time = 1.0;
    game = Soccer(config);
    game.kick_off(Side::Left);
    seconds(1.5);
    game.kick_off(Side::None);
    seconds(2.0);
    EXPECT_TRUE(game.over());
    EXPECT_EQ(game.result().game, "soccer");
    EXPECT_NEAR(game.result().metrics.at("time_s"), 2.0, 0.03);
}

TEST_F(SoccerRig, IsOverForGoodWhenAborted) {
    config.half_time = 1.0;
    game = Soccer(config);
    game.kick_off(Side::Left);
    seconds(0.5);
    game.abort(episode::Status::Diverged, "a body's state is out of bounds");
    EXPECT_TRUE(game.over()) << "whether or not it ends by itself";
    seconds(1.0);
    EXPECT_EQ(mode(), PlayMode::GameOver) << "no second half";
    game.abort(episode::Status::AgentLost, "later");
    EXPECT_EQ(game.result().status, episode::Status::Diverged);
    EXPECT_EQ(game.result().reason, "a body's state is out of bounds");
}

TEST_F(SoccerRig, GoalCountsPausesAndTheOthersKickOff) {
    play(Side::Left, 2, {14.0, 0.0});
    roll({14.5, 0.3, 0.042}, {4, 0, 0});
    step(20);
    EXPECT_EQ(mode(), PlayMode::GoalLeft);
    EXPECT_EQ(game.state().score_left, 1);
    EXPECT_TRUE(game.beam_allowed());
    seconds(2.9);
    EXPECT_EQ(mode(), PlayMode::KickOffRight);
    EXPECT_NEAR(scene.ball.position().head<2>().norm(), 0.0, 0.01);
    EXPECT_EQ(game.state().score_left, 1) << "one goal";
}

TEST_F(SoccerRig, RightTeamScoresInTheLeftGoalAlsoHigh) {
    play(Side::Right, 2, {-12.0, 0.0});
    roll({-14.8, -0.9, 0.6}, {-6, 0, 0.5});
    step(10);
    EXPECT_EQ(mode(), PlayMode::GoalRight);
    EXPECT_EQ(game.state().score_right, 1);
}

TEST_F(SoccerRig, OverTheBarIsNoGoal) {
    play(Side::Left, 2, {12.0, 0.0});
    roll({14.8, 0.0, 1.2}, {8, 0, 0});
    step(5);
    EXPECT_EQ(game.state().score_left, 0);
    EXPECT_EQ(mode(), PlayMode::GoalKickRight);
}

TEST_F(SoccerRig, NoGoalFromKickOffBeforeAnybodyElseHasTouched) {
    game.kick_off(Side::Left);
    step(2);
    touch(Side::Left, 1);
    step_away(Side::Left, 1);
    roll({14.5, 0.0, 0.042}, {4, 0, 0});
    step(20);
    EXPECT_EQ(mode(), PlayMode::GoalKickRight);
    EXPECT_EQ(game.state().score_left, 0);
}

TEST_F(SoccerRig, GoalCountsOnceAMateHasTouchedOutsideTheCircle) {
    game.kick_off(Side::Left);
    step(2);
    touch(Side::Left, 1);
    step_away(Side::Left, 1);
    roll({5.0, 0.0, 0.0402}, Vec3::Zero());
    touch(Side::Left, 2);
    step_away(Side::Left, 2);
    roll({14.5, 0.0, 0.042}, {4, 0, 0});
    step(20);
    EXPECT_EQ(mode(), PlayMode::GoalLeft);
}

TEST(LoneRobot, InTrainingIsLeftAlone) {
    body::Scene scene;
    Soccer game{SoccerConfig{}};
    body::Player& player = scene.add_player(0, {0, 0, 1});
    player.team = Side::Left;
    player.unum = 2;
    player.robot->place({-12, 0, 0.386}, 0.0);
    game.state().enter(PlayMode::PlayOn);
    scene.ball.move({0, -9, 0.042});
    for (int i = 0; i < 500; ++i) {
        scene.world.step();
        game.after_step(scene);
    }
    EXPECT_EQ(game.state().mode, PlayMode::PlayOn);
    EXPECT_NEAR(player.robot->torso_position().x(), -12.0, 0.05);
    EXPECT_NEAR(scene.ball.position().y(), -9.0, 1e-3);
    // Kicks from the centre spot, touching the ball as often as it likes.
    game.state().enter(PlayMode::BeforeKickOff);
    scene.world.step();
    game.after_step(scene);
    EXPECT_NEAR(scene.ball.position().head<2>().norm(), 0.0, 1e-3);
    game.kick_off(Side::Left);
    for (int i = 0; i < 20; ++i) {
        const Vec3 ball = scene.ball.position();
        player.robot->place({ball.x() - 0.13, ball.y() + 0.055, 0.386}, 0.0);
        scene.world.step();
        game.after_step(scene);
    }
    EXPECT_EQ(game.state().mode, PlayMode::PlayOn);
}

TEST_F(SoccerRig, WithoutRefereeTheBallMayLeaveAndNoHalfEnds) {
    config.referee = false;
    config.half_time = 2.0;
    game = Soccer(config);
    game.kick_off(Side::Left);
    step(2);
    touch(Side::Left, 1);
    EXPECT_EQ(mode(), PlayMode::PlayOn);
    step_away(Side::Left, 1);
    roll({3.0, 9.5, 0.042}, {0, 4, 0});
    seconds(3.0);
    EXPECT_EQ(mode(), PlayMode::PlayOn);
    EXPECT_GT(scene.ball.position().y(), 10.5);
    roll({14.5, 0.0, 0.042}, {4, 0, 0});
    step(20);
    EXPECT_EQ(game.state().score_left, 0);
}

}  // namespace
}  // namespace k3d::server::game
