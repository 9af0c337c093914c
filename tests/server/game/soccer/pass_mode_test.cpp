// SPDX-License-Identifier: BSD-3-Clause
// Pass mode: who may ask for it, what it gives, what it costs.
#include "server/game/soccer/pass_mode.h"

#include "server/game/soccer/match_rig.h"

namespace k3d::server::game {
namespace {

using wire::Side;

class Pass : public SoccerRig {
  protected:
    Pass() {
        mode(PlayMode::PlayOn);
        roll({2.0, 2.0, 0.0402}, Vec3::Zero());
        put(player(Side::Left, 1), 1.7, 2.0);
        step(2);
    }
    void ask(Side team, int unum) { game.pass(scene, player(team, unum)); }
};

TEST_F(Pass, KeepsOpponentsAMetreAwayForFourSeconds) {
    ask(Side::Left, 1);
    ASSERT_EQ(mode(), PlayMode::PassLeft);
    put(player(Side::Right, 1), 2.6, 2.0);
    step();
    EXPECT_GE((player(Side::Right, 1).robot->torso_position() - scene.ball.position()).head<2>().norm(),
              1.05);
    seconds(3.8);
    EXPECT_EQ(mode(), PlayMode::PassLeft);
    seconds(0.4);
    EXPECT_EQ(mode(), PlayMode::PlayOn);
    ask(Side::Left, 1);
    EXPECT_EQ(mode(), PlayMode::PlayOn) << "not again so soon";
    seconds(3.1);
    ask(Side::Left, 1);
    EXPECT_EQ(mode(), PlayMode::PassLeft);
}

TEST_F(Pass, EndsWithATouch) {
    ask(Side::Left, 1);
    step();
    touch(Side::Left, 1);
    EXPECT_EQ(mode(), PlayMode::PlayOn);
}

TEST_F(Pass, IsRefusedFarFromTheBallNearAnOpponentOrWhileItRolls) {
    ask(Side::Left, 2);
    EXPECT_EQ(mode(), PlayMode::PlayOn) << "too far";
    scene.ball.set_velocity({0.2, 0, 0});
    ask(Side::Left, 1);
    EXPECT_EQ(mode(), PlayMode::PlayOn) << "rolling";
    scene.ball.set_velocity(Vec3::Zero());
    put(player(Side::Right, 2), 2.8, 2.0);
    ask(Side::Left, 1);
    EXPECT_EQ(mode(), PlayMode::PlayOn) << "opponent near";
    mode(PlayMode::KickInLeft);
    put(player(Side::Right, 2), 8.0, 0.0);
    ask(Side::Left, 1);
    EXPECT_EQ(mode(), PlayMode::KickInLeft) << "only in play";
}

TEST_F(Pass, NoGoalUnlessTheBallWasPassed) {
    ask(Side::Left, 1);
    step();
    touch(Side::Left, 1);
    step_away(Side::Left, 1);
    roll({14.5, 0.0, 0.042}, {4, 0, 0});
    step(20);
    EXPECT_EQ(mode(), PlayMode::GoalKickRight);
}

TEST_F(Pass, TellsHowLongNoGoalCounts) {
    ask(Side::Left, 1);
    step();
    EXPECT_EQ(game.state().pass_wait_left, 0.0) << "only in play";
    touch(Side::Left, 1);
    ASSERT_EQ(mode(), PlayMode::PlayOn);
    const double first = game.state().pass_wait_left;
    EXPECT_NEAR(first, 10.0, 0.03);
    EXPECT_EQ(game.state().pass_wait_right, 0.0);
    step_away(Side::Left, 1);
    step(5);
    EXPECT_NEAR(game.state().pass_wait_left, first - 0.1, 1e-9);
    seconds(9.9);
    EXPECT_EQ(game.state().pass_wait_left, 0.0);
}

TEST_F(Pass, GoalCountsAfterAMateHasTakenThePass) {
    ask(Side::Left, 1);
    step();
    touch(Side::Left, 1);
    step_away(Side::Left, 1);
    step();
    roll({6.0, 2.0, 0.0402}, Vec3::Zero());
    touch(Side::Left, 1);
    step_away(Side::Left, 1);
    step();
    touch(Side::Left, 2);
    EXPECT_EQ(game.state().pass_wait_left, 0.0);
    step_away(Side::Left, 2);
    roll({14.5, 0.0, 0.042}, {4, 0, 0});
    step(20);
    EXPECT_EQ(mode(), PlayMode::GoalLeft);
}

}  // namespace
}  // namespace k3d::server::game
