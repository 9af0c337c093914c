// SPDX-License-Identifier: BSD-3-Clause
// The monitor port over real sockets: the stream, those who never read it, trainers and the barrier.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/sexpr/reader.h"
#include "integration/duel.h"

namespace k3d::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Reads frames until one holds the text; that frame.
std::string frame_with(net::Client& monitor, const std::string& text) {
    for (int i = 0; i < 2000; ++i) {
        std::string frame = next_frame(monitor);
        if (frame.empty() || holds(frame, text)) return frame;
    }
    return "";
}

/// Game time of a frame; -1 if it is no whole frame.
double time_of(const std::string& frame) {
    sexpr::Document document;
    if (document.parse(frame) != sexpr::Error::None) return -1.0;
    const auto time = document.first()->find("time");
    const auto value = time ? time->at(1)->number() : std::nullopt;
    return value.value_or(-1.0);
}

net::Client connect(const ServerProcess& server) {
    return net::Client("127.0.0.1", server.trainer_port(), kPatience);
}

TEST(MonitorStream, FullFrameAtOnceDifferencesThenAndFullForEachChange) {
    ServerProcess server({"--pace", "realtime"});
    net::Client monitor = connect(server);
    const std::string first = next_frame(monitor);
    EXPECT_THAT(first, HasSubstr("(play_mode 0))(RSG 0 1)((nd TRF"));
    EXPECT_THAT(first, Not(HasSubstr("naobody")));
    EXPECT_THAT(next_frame(monitor), HasSubstr("(RDS 0 1)"));

    WireAgent agent(server);
    agent.join(3, "Reds", 1);
    const std::string joined = frame_with(monitor, "(RSG 0 1)");
    EXPECT_THAT(joined, HasSubstr("models/naobody1.obj"));
    EXPECT_THAT(frame_with(monitor, "matNum3 matLeft matType1"), HasSubstr("(team_left Reds)"));
    monitor.send("(select (unum 3)(team Left))");
    for (int i = 0; i < 4; ++i) agent.step();
    EXPECT_THAT(frame_with(monitor, "(setVisible"), HasSubstr("(RDS 0 1)"));
    monitor.send("(reqfullstate)");
    for (int i = 0; i < 4; ++i) agent.step();
    EXPECT_THAT(frame_with(monitor, "(RSG 0 1)"), HasSubstr("(setVisible 1) (setTransparent)"));
    monitor.send("(kill (unum 3)(team Left))");
    EXPECT_THAT(frame_with(monitor, "(RSG 0 1)"), Not(HasSubstr("naobody")));
}

TEST(MonitorStream, WhoNeverReadsIsNotWaitedForAndGoesOnWithAFullFrame) {
    ServerProcess server(fast_with_one_agent());
    net::Client trainer = connect(server);
    WireAgent agent(server);
    agent.begin_match("Reds");
    // Full frames fill the kernel's buffers soonest. The server must go on all the time.
    trainer.send("(playMode PlayOn)(time 0)");
    for (int cycle = 0; cycle < 1500; ++cycle) {
        trainer.send("(reqfullstate)");
        agent.step("(rae1 1)");
    }
    trainer.send("(playMode KickIn_Left)");
    wire::Percepts percepts;
    for (int cycle = 0; cycle < 100; ++cycle) percepts = agent.step();
    EXPECT_EQ(percepts.game->play_mode, "KickIn_Left") << "it still obeys";
    const double now = percepts.game->time;
    EXPECT_NEAR(now, 32.0, 1.0);

    // Reading at last: whole frames in order, a gap, and behind it a full frame.
    double last = 0.0;
    bool gap = false;
    std::string frame;
    for (int i = 0; i < 2000 && last < now - 0.5; ++i) {
        frame = next_frame(trainer);
        const double time = time_of(frame);
        ASSERT_GE(time, last) << "frame " << i << " of " << frame.size() << " bytes";
        if (time > last + 0.1) {
            gap = true;
            EXPECT_THAT(frame, HasSubstr("(RSG 0 1)")) << "behind a gap";
        }
        last = time;
        if (i % 10 == 0) agent.step();  // new frames come only with new cycles
    }
    EXPECT_TRUE(gap) << "8 MB are more than the kernel buffers";
    EXPECT_NEAR(last, now, 0.5) << "the stream is up to date again";
}

TEST(Trainers, CanBeSwitchedOffWhileMonitorsWatch) {
    // Empty and without a clock it would send more differences than anybody reads.
    ServerProcess server({"--pace", "realtime", "--trainers", "off"});
    net::Client monitor = connect(server);
    next_frame(monitor);
    monitor.send("(killsim)(playMode PlayOn)(syn)");
    monitor.send("(reqfullstate)");
    const std::string full = frame_with(monitor, "(RSG 0 1)");
    EXPECT_THAT(full, HasSubstr("(play_mode 0)"));
    EXPECT_THAT(next_frame(monitor), HasSubstr("(RDS 0 1)"));
    EXPECT_THAT(server.log(), HasSubstr("may not command"));
}

TEST(Trainers, OfThisMachineMayCommandWhenLoopbackDoes) {
    ServerProcess server({"--pace", "fast", "--trainers", "loopback"});
    net::Client trainer = connect(server);
    trainer.send("(killsim)");
    const auto exit = server.child().wait(kPatience);
    ASSERT_TRUE(exit);
    EXPECT_EQ(exit->code, 0);
}

TEST(Barrier, CommandsActInFixedCyclesAndRunsAreDeterministic) {
    const episode::Result first = play_duel({}, kBallOut, "barrier");
    EXPECT_EQ(first.reason, "ball_out");
    EXPECT_EQ(first.seed, 1U);
    const episode::Result second = play_duel({}, kBallOut, "barrier");
    EXPECT_EQ(first.state_hash, second.state_hash);
    Script moved = kBallOut;
    moved[5] = "(agent (unum 1)(team Right)(pos -2 -2 0.5))(ball (vel 1 0 0))";
    const episode::Result other = play_duel({}, moved, "barrier");
    EXPECT_NE(first.state_hash, other.state_hash);
    EXPECT_EQ(other.state_hash, play_duel({}, moved, "barrier").state_hash);
    Script later = moved;
    later.erase(5);
    later[6] = moved[5];
    EXPECT_NE(other.state_hash, play_duel({}, later, "barrier").state_hash);
}

TEST(Barrier, HungTrainerIsGivenUpAndTheGameGoesOn) {
    // Longer than a busy machine lets our agent wait for its processor.
    ServerProcess server(fast_with_one_agent({"--hung-agent-s", "5"}));
    net::Client trainer = connect(server);
    WireAgent agent(server);
    agent.begin_match("Reds");
    trainer.send("(syn)");
    for (int cycle = 0; cycle < 20; ++cycle) agent.step();
    EXPECT_NE(frame_with(trainer, "(syn 1)"), "");
    EXPECT_EQ(next_frame(trainer), "") << "no second one, but the end of the connection";
    EXPECT_THAT(server.log(), HasSubstr("hangs: its (syn) is missing"));
}

}  // namespace
}  // namespace k3d::testing
