// SPDX-License-Identifier: BSD-3-Clause
// The wire as a foreign agent meets it: handshake, latency, trainer, say and hear, over real sockets.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "integration/server_process.h"

namespace k3d::testing {
namespace {

double joint_deg(const wire::Percepts& percepts, nao::JointId id) {
    return percepts.joints_deg[nao::index(id)];
}

TEST(Protocol, HandshakeTellsTeamAndNumberOnce) {
    ServerProcess server({"--pace", "sync"});
    WireAgent agent(server);
    agent.send("(scene rsg/agent/nao/nao_hetero.rsg 0)(syn)");
    wire::Percepts percepts;
    ASSERT_TRUE(agent.receive(percepts));
    EXPECT_FALSE(percepts.game->unum) << "no team before init";
    percepts = agent.step("(init (unum 0) (teamname Reds))");
    // Nobody is waited for yet: frames from before the init may lie in the socket.
    for (int i = 0; i < kMostFramesToSeat && !percepts.game->unum; ++i) percepts = agent.step();
    ASSERT_TRUE(percepts.game->unum);
    EXPECT_EQ(*percepts.game->unum, 1);
    EXPECT_EQ(*percepts.game->team, wire::Side::Left);
    for (int i = 0; i < 8; ++i) {
        percepts = agent.step();
        EXPECT_FALSE(percepts.game->unum) << "told again " << i + 1 << " frames later";
    }
    EXPECT_EQ(percepts.game->play_mode, "BeforeKickOff");
}

TEST(Protocol, NeckTurnsAtFullSpeedTwoFramesAfterTheCommand) {
    ServerProcess server(fast_with_one_agent());
    WireAgent agent(server);
    agent.begin_match("Reds");
    for (int i = 0; i < 60; ++i) agent.step();  // lands and settles
    // The command answers frame k; frame k+1 was sensed before it acts, frame k+2 shows it.
    EXPECT_NEAR(joint_deg(agent.step("(he1 6.1395)"), nao::JointId::HeadYaw), 0.0, 0.02);
    wire::Percepts percepts;
    for (int i = 1; i <= 5; ++i) {
        percepts = agent.step();
        EXPECT_NEAR(joint_deg(percepts, nao::JointId::HeadYaw), 7.035 * i, 0.1) << "step " << i;
    }
    EXPECT_NEAR(joint_deg(percepts, nao::JointId::HeadYaw), 35.2, 0.2);
}

TEST(Protocol, StandingRobotFeelsItsWeight) {
    ServerProcess server(fast_with_one_agent({"--ground-truth"}));
    WireAgent agent(server);
    agent.begin_match("Reds");
    wire::Percepts percepts;
    double head = 0.0;
    for (int i = 0; i < 150; ++i) {
        percepts = agent.step(i < 24 ? "(lae1 -3.2)(rae1 -3.2)" : "(lae1 0)(rae1 0)");
        if (percepts.see) head = percepts.see->my_position->z();
    }
    EXPECT_NEAR(head - 0.155, 0.385, 0.005) << "torso height";
    ASSERT_TRUE(percepts.feet[0] && percepts.feet[1]);
    EXPECT_NEAR(percepts.feet[0]->force.z() + percepts.feet[1]->force.z(), 45.2, 0.3);
    EXPECT_NEAR(percepts.acceleration.z(), 9.81, 0.05);
}

TEST(Protocol, TrainerMovesTheRobotToFaceTheGoal) {
    ServerProcess server(fast_with_one_agent({"--ground-truth"}));
    WireAgent agent(server);
    agent.begin_match("Reds");
    net::Client trainer("127.0.0.1", server.trainer_port(), kPatience);
    trainer.send("(playMode PlayOn)(agent (unum 1)(team Left)(move 0 0 0.4 -90))");
    trainer.send("(ball (pos 1 2 0.05) (vel 0 0 0))");
    wire::Percepts percepts;
    std::optional<wire::See> see;
    for (int i = 0; i < 600; ++i) {
        percepts = agent.step();
        if (percepts.see) see = percepts.see;
        if (see && std::abs(see->my_position->x()) < 0.1 && i > 50) break;
    }
    ASSERT_TRUE(see);
    EXPECT_NEAR(*see->my_orientation_deg, 0.0, 0.5);
    EXPECT_NEAR(see->my_position->head<2>().norm(), 0.0, 0.05);
    EXPECT_NEAR(see->ball_position->y(), 2.0, 0.05);
    EXPECT_EQ(percepts.game->play_mode, "PlayOn");
}

TEST(Protocol, BeamPlacesTheRobotInItsOwnHalf) {
    ServerProcess server(fast_with_one_agent({"--ground-truth", "--noise", "off"}));
    WireAgent agent(server);
    agent.begin_match("Reds");
    wire::Percepts percepts = agent.step("(beam -3 1 20)");
    std::optional<wire::See> see;
    for (int i = 0; i < 60; ++i) {
        percepts = agent.step();
        if (percepts.see) see = percepts.see;
    }
    ASSERT_TRUE(see);
    // 2 cm as the wire prints them: -2.98 is not within 0.02 of -3 in binary.
    EXPECT_NEAR(see->my_position->x(), -3.0, 0.02 + 1e-9);
    EXPECT_NEAR(see->my_position->y(), 1.0, 0.02 + 1e-9);
    EXPECT_NEAR(*see->my_orientation_deg, 20.0, 0.2);
}

TEST(Protocol, OneMateIsHeardEverySecondCycleAndTheFirstSpeakerWins) {
    // The keepaway lobby brings all to the same cycle; nothing is said before the robots stand.
    ServerProcess server({"--game", "keepaway", "--pace", "fast", "--keepers", "3", "--takers", "1",
                          "--left-team", "Reds"});
    WireAgent listener(server), first(server), second(server), opponent(server);
    const std::array<WireAgent*, 4> all{&listener, &first, &second, &opponent};
    for (WireAgent* agent : all) {
        agent->send("(scene rsg/agent/nao/nao.rsg)(syn)");
        wire::Percepts percepts;
        ASSERT_TRUE(agent->receive(percepts));
    }
    listener.step("(init (unum 1)(teamname Reds))");
    first.step("(init (unum 2)(teamname Reds))");
    second.step("(init (unum 3)(teamname Reds))");
    opponent.step("(init (unum 1)(teamname Blues))");
    const auto step_all = [&](const std::string& talk) {
        const std::array<std::string, 4> says{"", "(say A" + talk + ")", "(say B" + talk + ")", ""};
        for (std::size_t i = 0; i < all.size(); ++i) all[i]->send(says[i] + "(syn)");
        std::array<wire::Percepts, 4> percepts;
        for (std::size_t i = 0; i < all.size(); ++i) EXPECT_TRUE(all[i]->receive(percepts[i]));
        return percepts[0];
    };
    for (int i = 0; i < 10; ++i) step_all("");
    int heard = 0;
    std::optional<int> last;
    for (int frame = 0; frame < 100; ++frame) {
        for (const wire::Heard& h : step_all(std::to_string(frame)).heard) {
            ASSERT_TRUE(h.direction_deg) << "the listener itself is silent";
            EXPECT_EQ(h.text[0], 'A') << "the lower number's message is broadcast first";
            if (last) {
                EXPECT_EQ(frame - *last, 2);
            }
            last = frame;
            ++heard;
        }
    }
    EXPECT_NEAR(heard, 50, 1);
}

TEST(Protocol, FramesToAnAgentCarryNoGroundTruthUnlessAsked) {
    ServerProcess server(fast_with_one_agent());
    WireAgent agent(server);
    agent.begin_match("Reds");
    for (int i = 0; i < 100; ++i) {
        agent.step();
        for (const char* truth : {"mypos", "myorien", "ballpos"}) {
            ASSERT_EQ(agent.last_payload().find(truth), std::string::npos) << agent.last_payload();
        }
    }
}

}  // namespace
}  // namespace k3d::testing
