// SPDX-License-Identifier: BSD-3-Clause
// Who gets which frame, who may command, and the barrier, with connections played by the test.
#include "server/session/monitors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

namespace k3d::server::session {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// The peer's end of a connection.
struct Peer {
    std::deque<std::string> to_server;
    std::vector<std::string> received;
    bool reads = true;
    bool closed = false;
    std::string why;
};

class FakeConnection final : public net::Connection {
  public:
    explicit FakeConnection(Peer& peer) : peer_(peer) {}
    bool next_frame(std::string_view& payload) override {
        if (peer_.to_server.empty()) return false;
        frame_ = peer_.to_server.front();
        peer_.to_server.pop_front();
        payload = frame_;
        return true;
    }
    bool send(std::string_view payload) override {
        if (!ready()) return false;
        peer_.received.emplace_back(payload);
        return true;
    }
    bool ready() override { return !peer_.closed && peer_.reads; }
    bool closed() const override { return peer_.closed; }
    bool spent() const override { return closed(); }
    bool broke_limit() const override { return false; }
    const std::string& close_reason() const override { return peer_.why; }
    const std::string& peer() const override { return name_; }
    void close(std::string_view reason) override {
        peer_.closed = true;
        peer_.why = reason;
    }

  private:
    Peer& peer_;
    std::string frame_;
    std::string name_ = "test";
};

std::string full(int turn) { return "((time " + std::to_string(turn) + "))(RSG 0 1)()"; }
std::string difference(int turn) { return "((time " + std::to_string(turn) + "))(RDS 0 1)()"; }

/// Monitors with peers, and frames that tell their kind and turn.
struct Rig {
    explicit Rig(bool barrier = true)
        : monitors(barrier, [this](int id) { left.push_back(id); }) {}

    Peer& connect(bool commands = true) {
        Peer& peer = *peers.emplace_back(std::make_unique<Peer>());
        monitors.accept(std::make_unique<FakeConnection>(peer), static_cast<int>(peers.size()),
                        commands);
        return peer;
    }
    void turn() {
        ++turns;
        monitors.send(source);
    }
    std::string commands() {
        std::string text;
        for (const auto& order : monitors.take_commands()) wire::encode(order.command, text);
        return text;
    }
    std::string frame(const char* header) {
        ++composed;
        return "((time " + std::to_string(turns) + "))(" + header + " 0 1)()";
    }

    std::vector<std::unique_ptr<Peer>> peers;
    std::vector<int> left;
    Monitors monitors;
    int turns = 0;
    int composed = 0;
    FrameSource source{[this] { return frame("RSG"); }, [this] { return frame("RDS"); }};
};

TEST(Monitors, FullFrameFirstThenDifferences) {
    Rig rig;
    Peer& early = rig.connect();
    rig.turn();
    Peer& late = rig.connect();
    rig.turn();
    rig.turn();
    EXPECT_THAT(early.received, ElementsAre(full(1), difference(2), difference(3)));
    EXPECT_THAT(late.received, ElementsAre(full(2), difference(3)));
    EXPECT_EQ(rig.composed, 4) << "each kind once a turn, however many watch";
}

TEST(Monitors, NobodyReadyMeansNothingComposed) {
    Rig rig;
    rig.turn();
    EXPECT_FALSE(rig.monitors.watched());
    Peer& peer = rig.connect();
    EXPECT_TRUE(rig.monitors.watched());
    peer.reads = false;
    rig.turn();
    EXPECT_FALSE(rig.monitors.watched());
    EXPECT_EQ(rig.composed, 0);
}

TEST(Monitors, AGapEndsWithAFullFrame) {
    Rig rig;
    Peer& peer = rig.connect();
    rig.turn();
    peer.reads = false;
    rig.turn();
    rig.turn();
    peer.reads = true;
    rig.turn();
    rig.turn();
    EXPECT_THAT(peer.received, ElementsAre(full(1), full(4), difference(5)));
}

TEST(Monitors, OtherStructureMeansFullFramesForAll) {
    Rig rig;
    Peer& peer = rig.connect();
    rig.turn();
    rig.monitors.require_full();
    rig.turn();
    rig.turn();
    EXPECT_THAT(peer.received, ElementsAre(full(1), full(2), difference(3)));
}

TEST(Monitors, FullStateGoesToWhoAskedForIt) {
    Rig rig;
    Peer& asks = rig.connect(false);
    Peer& other = rig.connect();
    rig.turn();
    asks.to_server = {"(reqfullstate)"};
    rig.monitors.read();
    rig.turn();
    EXPECT_THAT(asks.received, ElementsAre(full(1), full(2)));
    EXPECT_THAT(other.received, ElementsAre(full(1), difference(2)));
    EXPECT_EQ(rig.commands(), "");
}

TEST(Monitors, CommandsComeInOrderOfAcceptance) {
    Rig rig;
    Peer& first = rig.connect();
    Peer& second = rig.connect();
    Peer& watcher = rig.connect(false);
    second.to_server = {"(time 2)"};
    first.to_server = {"(time 1)(kickOff Left)", "(dropBall) (getAck)(init)"};
    watcher.to_server = {"(killsim)(syn)"};
    EXPECT_TRUE(rig.monitors.read()) << "who may not command is not waited for";
    EXPECT_EQ(rig.commands(), "(time 1)(kickOff Left)(dropBall)(time 2)");
    EXPECT_EQ(rig.commands(), "") << "taken once";
}

TEST(Monitors, LastCommandsOfOneThatLeftStillCount) {
    Rig rig;
    Peer& peer = rig.connect();
    peer.to_server = {"(killsim)"};
    peer.closed = true;
    rig.monitors.read();
    EXPECT_EQ(rig.commands(), "(killsim)");
    rig.monitors.read();
    EXPECT_THAT(rig.left, ElementsAre(1));
}

TEST(Monitors, BarrierWaitsForOneSynATurn) {
    Rig rig;
    Peer& peer = rig.connect();
    EXPECT_TRUE(rig.monitors.read()) << "not in the barrier yet";
    rig.turn();
    peer.to_server = {"(time 1)(syn)"};
    EXPECT_TRUE(rig.monitors.read());
    EXPECT_EQ(rig.commands(), "(time 1)");
    rig.turn();
    EXPECT_THAT(peer.received, ElementsAre(full(1), "((time 2)(syn 1))(RDS 0 1)()"))
        << "it knows which frames to answer";
    EXPECT_FALSE(rig.monitors.read());
    peer.to_server = {"(time 2)"};
    EXPECT_FALSE(rig.monitors.read()) << "still no (syn)";
    peer.to_server = {"(syn)", "(time 3)(syn)", "(time 4)"};
    EXPECT_TRUE(rig.monitors.read());
    EXPECT_TRUE(rig.monitors.read());
    EXPECT_EQ(rig.commands(), "(time 2)") << "what stands behind the (syn) is of the next turn";
    rig.turn();
    EXPECT_TRUE(rig.monitors.read());
    EXPECT_EQ(rig.commands(), "(time 3)");
    rig.turn();
    EXPECT_FALSE(rig.monitors.read());
    peer.closed = true;
    EXPECT_TRUE(rig.monitors.read()) << "it leaves the barrier with its connection";
    EXPECT_EQ(rig.commands(), "(time 4)");
}

TEST(Monitors, BarrierHoldsForTrainersThatNeverRead) {
    Rig rig;
    Peer& peer = rig.connect();
    peer.reads = false;
    peer.to_server = {"(time 1)(syn)", "(time 2)(syn)", "(time 3)(syn)"};
    for (const char* turn : {"(time 1)", "(time 2)", "(time 3)"}) {
        EXPECT_TRUE(rig.monitors.read());
        EXPECT_EQ(rig.commands(), turn);
        rig.turn();
    }
    EXPECT_FALSE(rig.monitors.read());
    EXPECT_THAT(peer.received, IsEmpty());
}

TEST(Monitors, HungTrainersAreGivenUp) {
    Rig rig;
    Peer& trainer = rig.connect();
    Peer& watcher = rig.connect();
    trainer.to_server = {"(syn)"};
    rig.monitors.read();
    rig.turn();
    EXPECT_FALSE(rig.monitors.read());
    rig.monitors.close_hung();
    EXPECT_TRUE(trainer.closed);
    EXPECT_FALSE(watcher.closed);
    EXPECT_TRUE(rig.monitors.read());
    EXPECT_THAT(rig.left, ElementsAre(1));
}

TEST(Monitors, WithoutABarrierSynIsHarmless) {
    Rig rig(false);
    Peer& peer = rig.connect();
    peer.to_server = {"(syn)", "(time 1)(syn)"};
    EXPECT_TRUE(rig.monitors.read());
    EXPECT_EQ(rig.commands(), "(time 1)");
    rig.turn();
    EXPECT_TRUE(rig.monitors.read());
    EXPECT_THAT(peer.received, ElementsAre(full(1)));
}

TEST(Monitors, LobbyGreetsOnceAndOnRequest) {
    Rig rig;
    Peer& peer = rig.connect();
    rig.monitors.greet(rig.source);
    rig.monitors.greet(rig.source);
    EXPECT_THAT(peer.received, ElementsAre(full(0)));
    peer.to_server = {"(reqfullstate)"};
    rig.monitors.read();
    rig.monitors.greet(rig.source);
    EXPECT_EQ(peer.received.size(), 2U);
    // In the barrier the next frame is one that must be answered: it belongs to the first cycle.
    peer.to_server = {"(syn)(reqfullstate)"};
    rig.monitors.read();
    rig.monitors.greet(rig.source);
    EXPECT_EQ(peer.received.size(), 2U);
    rig.turn();
    EXPECT_EQ(peer.received.back(), "((time 1)(syn 1))(RSG 0 1)()");
}

TEST(Monitors, WhoMayCommand) {
    EXPECT_TRUE(may_command("all", "10.0.0.7:4000"));
    EXPECT_TRUE(may_command("loopback", "127.0.0.1:4000"));
    EXPECT_TRUE(may_command("loopback", "[::1]:4000"));
    EXPECT_TRUE(may_command("loopback", "[::ffff:127.0.0.1]:4000"));
    EXPECT_FALSE(may_command("loopback", "[::ffff:10.0.0.7]:4000"));
    EXPECT_FALSE(may_command("loopback", "10.0.0.7:4000"));
    EXPECT_FALSE(may_command("loopback", "[fe80::127.0]:4000"));
    EXPECT_FALSE(may_command("off", "127.0.0.1:4000"));
}

}  // namespace
}  // namespace k3d::server::session
