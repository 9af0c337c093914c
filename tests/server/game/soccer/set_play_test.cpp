// SPDX-License-Identifier: BSD-3-Clause
// Balls out of play and how they come back: kick-in, corner, goal kick, free kick, dropped ball.
#include "server/game/soccer/set_play.h"

#include "server/game/soccer/match_rig.h"
#include "server/game/trainer.h"

namespace k3d::server::game {
namespace {

using wire::Side;

TEST_F(SoccerRig, OverTheSideLineIsAKickInForTheOthers) {
    play(Side::Left, 1, {3.0, 9.0});
    roll({3.0, 9.9, 0.042}, {0, 3, 0});
    step(10);
    ASSERT_EQ(mode(), PlayMode::KickInRight);
    seconds(0.5);
    EXPECT_GT(scene.ball.position().y(), 10.0) << "at first the ball rolls on";
    put(player(Side::Left, 1), 3.0, 9.0);
    put(player(Side::Right, 1), 3.0, 9.7);
    seconds(0.6);
    EXPECT_NEAR(scene.ball.position().x(), 3.0, 0.1);
    EXPECT_NEAR(scene.ball.position().y(), 10.0 - 0.042, 0.01);
    EXPECT_GE((player(Side::Left, 1).robot->torso_position() - scene.ball.position()).head<2>().norm(),
              2.0) << "opponents keep away";
    EXPECT_GE((player(Side::Right, 1).robot->torso_position() - scene.ball.position()).head<2>().norm(),
              0.45) << "and who takes it stands off the spot";
    touch(Side::Right, 1);
    EXPECT_EQ(mode(), PlayMode::PlayOn);
}

TEST_F(SoccerRig, KickInThatNobodyTakesIsDropped) {
    play(Side::Left, 1, {3.0, 9.0});
    roll({3.0, 9.9, 0.042}, {0, 3, 0});
    seconds(15.5);
    EXPECT_EQ(mode(), PlayMode::PlayOn);
    EXPECT_NEAR(scene.ball.position().y(), 10.0 - 0.042, 0.05);
}

TEST_F(SoccerRig, OwnGoalLineGivesACorner) {
    play(Side::Right, 1, {13.0, 5.0});
    roll({14.9, 5.0, 0.042}, {3, 0, 0});
    step(10);
    ASSERT_EQ(mode(), PlayMode::CornerKickLeft);
    seconds(1.2);
    EXPECT_NEAR(scene.ball.position().x(), 15.0 - 0.042, 0.01);
    EXPECT_NEAR(scene.ball.position().y(), (20.0 + 2.1) / 4.0 - 0.042, 0.01);
    touch(Side::Left, 2);
    EXPECT_EQ(mode(), PlayMode::PlayOn);
    EXPECT_EQ(game.state().score_left, 0);
}

TEST_F(SoccerRig, GoalKickIsTakenWhenTheBallHasLeftThePenaltyArea) {
    play(Side::Right, 1, {-13.0, 5.0});
    roll({-14.9, 5.0, 0.042}, {-3, 0, 0});
    step(10);
    ASSERT_EQ(mode(), PlayMode::GoalKickLeft);
    put(player(Side::Right, 1), -14.0, 2.0);
    seconds(1.2);
    EXPECT_NEAR(scene.ball.position().x(), -14.0, 0.01);
    EXPECT_GT(player(Side::Right, 1).robot->torso_position().x(), -13.2) << "out of the area";
    touch(Side::Left, 1);
    EXPECT_EQ(mode(), PlayMode::GoalKickLeft) << "still within the area";
    step_away(Side::Left, 1);
    roll({-13.4, 0.0, 0.042}, {3, 0, 0});
    step(10);
    EXPECT_EQ(mode(), PlayMode::PlayOn);
}

TEST_F(SoccerRig, WhoTakesAKickMayNotTouchAgain) {
    play(Side::Left, 1, {3.0, 9.0});
    roll({3.0, 9.9, 0.042}, {0, 3, 0});
    seconds(1.5);
    ASSERT_EQ(mode(), PlayMode::KickInRight);
    touch(Side::Right, 1);
    ASSERT_EQ(mode(), PlayMode::PlayOn);
    step_away(Side::Right, 1);
    roll({5.0, 5.0, 0.0402}, Vec3::Zero());
    step(20);
    EXPECT_EQ(mode(), PlayMode::PlayOn);
    touch(Side::Right, 1);
    EXPECT_EQ(mode(), PlayMode::FreeKickLeft);
    step_away(Side::Right, 1);
    seconds(1.2);
    EXPECT_NEAR(scene.ball.position().x(), 5.0, 0.1) << "from where it was touched";
    touch(Side::Left, 2);
    EXPECT_EQ(mode(), PlayMode::PlayOn);
}

TEST_F(SoccerRig, ATrainersDroppedBallMayBeTouchedByWhoKickedIt) {
    play(Side::Left, 1, {3.0, 9.0});
    roll({3.0, 9.9, 0.042}, {0, 3, 0});
    seconds(1.5);
    ASSERT_EQ(mode(), PlayMode::KickInRight);
    touch(Side::Right, 1);
    ASSERT_EQ(mode(), PlayMode::PlayOn);
    step_away(Side::Right, 1);
    step(20);
    Game match = game;
    apply(wire::DropBallCommand{}, scene, match);
    game = std::get<Soccer>(match);
    step();
    touch(Side::Right, 1);
    EXPECT_EQ(mode(), PlayMode::PlayOn) << "its kick-in is no longer in force";
}

TEST_F(SoccerRig, AfterAnothersTouchTheTakerMayPlayOn) {
    play(Side::Left, 1, {3.0, 9.0});
    roll({3.0, 9.9, 0.042}, {0, 3, 0});
    seconds(1.5);
    touch(Side::Right, 1);
    step_away(Side::Right, 1);
    roll({5.0, 5.0, 0.0402}, Vec3::Zero());
    step(20);
    touch(Side::Left, 3);
    step_away(Side::Left, 3);
    step(20);
    touch(Side::Right, 1);
    EXPECT_EQ(mode(), PlayMode::PlayOn);
}

TEST_F(SoccerRig, NoGoalStraightFromAKickIn) {
    play(Side::Left, 1, {3.0, 9.0});
    roll({3.0, 9.9, 0.042}, {0, 3, 0});
    seconds(1.5);
    ASSERT_EQ(mode(), PlayMode::KickInRight);
    touch(Side::Right, 1);
    step_away(Side::Right, 1);
    roll({-14.5, 0.0, 0.042}, {-4, 0, 0});
    step(20);
    EXPECT_EQ(mode(), PlayMode::GoalKickLeft);
    EXPECT_EQ(game.state().score_right, 0);
}

TEST_F(SoccerRig, FreeKickInAPenaltyAreaIsTakenFromItsCorner) {
    roll({14.0, 1.0, 0.042}, Vec3::Zero());
    mode(PlayMode::DirectFreeKickLeft);
    seconds(1.2);
    EXPECT_NEAR(scene.ball.position().x(), 13.2, 0.01);
    EXPECT_NEAR(scene.ball.position().y(), 3.0, 0.01);
}

TEST_F(SoccerRig, EveryModeOfTheTrainerIsPlayedOut) {
    config.half_time = 3600.0;
    game = Soccer(config);
    for (int index = 0; index <= static_cast<int>(PlayMode::PassRight); ++index) {
        const auto start = static_cast<PlayMode>(index);
        if (start == PlayMode::GameOver || start == PlayMode::BeforeKickOff) continue;
        roll({4.0, 3.0, 0.042}, Vec3::Zero());
        mode(start);
        seconds(19.0);
        EXPECT_EQ(mode(), PlayMode::PlayOn) << name(start);
        mode(PlayMode::BeforeKickOff);
        step();
    }
}

}  // namespace
}  // namespace k3d::server::game
