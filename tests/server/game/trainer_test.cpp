// SPDX-License-Identifier: BSD-3-Clause
// What each trainer command does to a scene and a game.
#include "server/game/trainer.h"

#include <gtest/gtest.h>

namespace k3d::server::game {
namespace {

struct Rig {
    body::Scene scene;
    Game game{Soccer(SoccerConfig{})};

    body::Player& add(wire::Side team, int unum, const Vec3& at) {
        body::Player& player = scene.add_player(0, at);
        player.team = team;
        player.unum = unum;
        return player;
    }
    /// Applies what a frame holds; the effect of the last command.
    TrainerEffect operator()(const char* frame) {
        std::vector<wire::TrainerCommand> commands;
        EXPECT_EQ(wire::decode(frame, commands), 0) << frame;
        TrainerEffect effect;
        for (const auto& command : commands) effect = apply(command, scene, game);
        return effect;
    }
    GameState& now() { return state(game); }
};

void expect_near(const Vec3& a, const Vec3& b) { EXPECT_LT((a - b).norm(), 1e-9) << a << "\n" << b; }

TEST(Trainer, MovesTheBall) {
    Rig rig;
    rig("(ball (pos 1 2 0.5)(vel 3 0 1))");
    expect_near(rig.scene.ball.position(), {1, 2, 0.5});
    expect_near(rig.scene.ball.velocity(), {3, 0, 1});
    rig("(ball (pos -1 0 0.1))");
    expect_near(rig.scene.ball.velocity(), {3, 0, 1});
}

TEST(Trainer, MovesAndTurnsAPlayer) {
    Rig rig;
    body::Robot& robot = *rig.add(wire::Side::Right, 7, {1, 1, 0.4}).robot;
    rig("(agent (team Right)(unum 7)(pos 5 5 1))");
    expect_near(robot.torso_position(), {5, 5, 1});
    EXPECT_NEAR(robot.heading(), kPi / 2, 1e-9);
    rig("(agent (unum 7)(team Right)(move -6 2 0.4 -90))");
    expect_near(robot.torso_position(), {-6, 2, 0.4});
    EXPECT_NEAR(robot.heading(), 0.0, 1e-9);
    rig("(agent (unum 99)(team Right)(pos 0 0 0))(agent (unum 7)(team Left)(pos 0 0 0))"
        "(agent (unum 7)(team Right)(battery 50))");
    expect_near(robot.torso_position(), {-6, 2, 0.4});
}

TEST(Trainer, SetsModeTimeAndScore) {
    Rig rig;
    rig("(playMode corner_kick_left)(time 123.4)(score (left 3)(right 2))");
    EXPECT_EQ(rig.now().mode, PlayMode::CornerKickLeft);
    EXPECT_EQ(rig.now().time, 123.4);
    EXPECT_EQ(rig.now().score_left, 3);
    EXPECT_EQ(rig.now().score_right, 2);
    rig("(playMode bogus_mode)");
    EXPECT_EQ(rig.now().mode, PlayMode::CornerKickLeft);
    rig("(kickOff Right)");
    EXPECT_EQ(rig.now().mode, PlayMode::KickOffRight);
    rig("(kickOff Left)");
    EXPECT_EQ(rig.now().mode, PlayMode::KickOffLeft);
    rig("(playMode PlayOn)(kickOff None)");
    EXPECT_EQ(rig.now().mode, PlayMode::KickOffLeft) << "the first half is the left team's";
    rig.now().half = 2;
    rig("(playMode PlayOn)(kickOff None)");
    EXPECT_EQ(rig.now().mode, PlayMode::KickOffRight);
}

TEST(Trainer, SelectsOneAtATimeAndTheNext) {
    Rig rig;
    body::Player& one = rig.add(wire::Side::Left, 1, {0, 1, 0.4});
    body::Player& two = rig.add(wire::Side::Left, 2, {0, 2, 0.4});
    rig("(select (unum 2)(team Left))");
    EXPECT_TRUE(two.selected);
    rig("(select (unum 3)(team Left))");
    EXPECT_TRUE(two.selected) << "nobody has number 3";
    rig("(select)");
    EXPECT_TRUE(one.selected) << "after the last comes the first";
    EXPECT_FALSE(two.selected);
    rig("(select)");
    EXPECT_TRUE(two.selected);
    rig("(select (unum -1))");
    EXPECT_FALSE(one.selected || two.selected);
    rig("(select)");
    EXPECT_TRUE(one.selected);
}

TEST(Trainer, KillsTheNamedOrTheSelectedPlayer) {
    Rig rig;
    const int one = rig.add(wire::Side::Left, 1, {0, 1, 0.4}).id;
    const int two = rig.add(wire::Side::Right, 2, {0, 2, 0.4}).id;
    EXPECT_EQ(rig("(kill (unum 2)(team Right))").killed, two);
    EXPECT_EQ(rig("(kill (unum 2)(team Left))").killed, std::nullopt);
    EXPECT_EQ(rig("(kill)").killed, std::nullopt) << "nobody is selected";
    EXPECT_EQ(rig("(select (unum 1)(team Left))(kill)").killed, one);
    EXPECT_TRUE(rig("(killsim)").end_simulation);
}

TEST(Trainer, ReposPutsAPlayerBesideTheFieldAwayFromTheBall) {
    Rig rig;
    body::Robot& left = *rig.add(wire::Side::Left, 1, {0, 1, 0.4}).robot;
    body::Robot& right = *rig.add(wire::Side::Right, 3, {0, 2, 0.4}).robot;
    rig("(repos (unum 1)(team Left))");
    expect_near(left.torso_position(), {-3.6, -10.5, 1.0});  // as measured
    rig("(ball (pos 0 -3 0.042))(select (unum 3)(team Right))(repos)");
    expect_near(right.torso_position(), {2.4, 10.5, 1.0});
}

TEST(Trainer, BareAgentSendsTheSelectedPlayerBack) {
    Rig rig;
    body::Robot& near_line = *rig.add(wire::Side::Left, 1, {-14, 3, 0.4}).robot;
    body::Robot& right = *rig.add(wire::Side::Right, 2, {1, 2, 0.4}).robot;
    rig("(agent)");
    expect_near(right.torso_position(), {1, 2, 0.4});
    rig("(select (unum 2)(team Right))(agent)");
    expect_near(right.torso_position(), {3.5, 2, 0.4});
    rig("(select (unum 1)(team Left))(agent)");
    expect_near(near_line.torso_position(), {-14, 0.5, 0.4});
}

TEST(Trainer, KeepawayKeepsItsModeAndTime) {
    Rig rig;
    KeepawayConfig config;
    config.keepers = config.takers = 1;
    rig.add(wire::Side::Left, 1, {0, 0, 1});
    rig.add(wire::Side::Right, 1, {0, 0, 1});
    rig.game.emplace<Keepaway>(config, 5, rig.scene);
    rig.now().mode = PlayMode::PlayOn;
    rig.now().time = 7.0;
    rig("(ball (pos 1 2 0.5)(vel 3 0 1))");
    for (const char* command : {"(playMode GameOver)", "(playMode free_kick_left)", "(dropBall)",
                                "(time 0)", "(kickOff Left)"}) {
        EXPECT_EQ(rig(command).ignored, "keepaway keeps its own time and play modes") << command;
        EXPECT_EQ(rig.now().mode, PlayMode::PlayOn) << command;
        EXPECT_EQ(rig.now().time, 7.0) << command;
        expect_near(rig.scene.ball.velocity(), {3, 0, 1});
    }
    EXPECT_EQ(rig("(ball (pos 0 0 0.042))").ignored, "");
    EXPECT_EQ(rig("(select (unum 1)(team Left))").ignored, "");
    Rig soccer;
    EXPECT_EQ(soccer("(playMode PlayOn)(time 3)").ignored, "");
}

TEST(Trainer, SaysWhyACommandIsIgnored) {
    Rig rig;
    rig.add(wire::Side::Left, 1, {0, 1, 0.4});
    EXPECT_EQ(rig("(playMode bogus_mode)").ignored, "there is no such play mode");
    for (const char* command :
         {"(agent (unum 2)(team Left)(pos 0 0 1))", "(kill (unum 1)(team Right))",
          "(repos (unum 2)(team Left))", "(select (unum 2)(team Left))"}) {
        EXPECT_EQ(rig(command).ignored, "there is no such player") << command;
    }
    for (const char* command : {"(agent)", "(kill)", "(repos)"}) {
        EXPECT_EQ(rig(command).ignored, "no player is selected") << command;
    }
    for (const char* command : {"(select (unum 1)(team Left))", "(agent)", "(kill)", "(repos)",
                                "(agent (unum 1)(team Left)(battery 50))", "(select)",
                                "(select (unum -1))", "(reqfullstate)"}) {
        EXPECT_EQ(rig(command).ignored, "") << command;
    }
}

TEST(Trainer, DropBallClearsTheSpotAndPlaysOn) {
    Rig rig;
    body::Robot& near_left = *rig.add(wire::Side::Left, 1, {0.5, 0.3, 0.4}).robot;
    body::Robot& near_right = *rig.add(wire::Side::Right, 1, {0, -1, 0.4}).robot;
    body::Robot& far_away = *rig.add(wire::Side::Right, 2, {5, 5, 0.4}).robot;
    rig("(playMode KickOff_Left)(ball (pos 0 0 0.042)(vel 2 0 0))(dropBall)");
    EXPECT_EQ(rig.now().mode, PlayMode::PlayOn);
    expect_near(rig.scene.ball.position(), {0, 0, 0.042});
    expect_near(rig.scene.ball.velocity(), Vec3::Zero());
    expect_near(near_left.torso_position(), {-2.5, 0.3, 0.4});
    expect_near(near_right.torso_position(), {2.5, -1, 0.4});
    expect_near(far_away.torso_position(), {5, 5, 0.4});
    rig("(ball (pos 14 -1 0.042))(dropBall)");
    expect_near(rig.scene.ball.position(), {13.2, -3, 0.042});
    rig("(ball (pos 3 12 0.042))(dropBall)");
    expect_near(rig.scene.ball.position(), {3, 9.958, 0.042});
}

}  // namespace
}  // namespace k3d::server::game
