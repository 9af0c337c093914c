// SPDX-License-Identifier: BSD-3-Clause
// Strangers that want to hurt a running match: its agents get a frame every cycle, and every body
// moves as if nobody else were there.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "common/episode/result.h"
#include "common/random/stream.h"
#include "integration/raw_socket.h"
#include "integration/server_process.h"

namespace k3d::testing {
namespace {

std::string framed(const std::string& payload) {
    std::string bytes;
    wire::append_frame(payload, bytes);
    return bytes;
}

std::string noise(RandomStream& random, int longest) {
    std::string bytes(static_cast<std::size_t>(random.below(longest)), ' ');
    for (char& c : bytes) c = static_cast<char>(random.below(256));
    return bytes;
}

/// A process of its own that sends half a frame; ended by SIGKILL, mid-frame.
class DoomedPeer {
  public:
    explicit DoomedPeer(std::uint16_t port) : pid_(::fork()) {
        if (pid_ != 0) return;
        RawSocket socket(port);
        socket.write(framed("(scene rsg/agent/nao/nao.rsg)") + framed("(init (unum 1)").substr(0, 9));
        for (;;) ::pause();
    }
    ~DoomedPeer() {
        ::kill(pid_, SIGKILL);
        ::waitpid(pid_, nullptr, 0);
    }
    DoomedPeer(const DoomedPeer&) = delete;
    DoomedPeer& operator=(const DoomedPeer&) = delete;

  private:
    pid_t pid_;
};

/// All kinds of strangers on one port; act() once a cycle of the match.
class Strangers {
  public:
    explicit Strangers(std::uint16_t port)
        : port_(port), slow_reader_(port), slow_writer_(port), half_open_(port), half_frame_(port),
          huge_(port), late_(port), doomed_(std::make_unique<DoomedPeer>(port)) {
        slow_reader_.write(framed("(reqfullstate)") + framed("(scene rsg/agent/nao/nao.rsg)"));
        half_open_.write(framed("(scene rsg/agent/nao/nao.rsg)"));
        half_open_.end_writing();
        half_frame_.write(framed(std::string(256, ' ')).substr(0, 8));
        late_.write(framed("(scene rsg/agent/nao/nao.rsg)") + framed("(init (unum 1)(teamname Keepers))"));
        huge_.write("\xff\xff\xff\xff(he1 1)");
    }

    /// The server may end while we act; connects() tells whether it did too early.
    void act(int cycle) try {
        constexpr int kConnectsPerCycle = 20;  // 10,000 in a match of 500 cycles on two ports
        for (int i = 0; i < kConnectsPerCycle; ++i, ++connects_) {
            RawSocket come_and_go(port_);
            if (i % 4 == 0) come_and_go.write(framed("(bah)"));
        }
        if (cycle % 50 == 0) slow_writer_.write(framed("(he1 1)(syn)").substr(static_cast<std::size_t>(cycle / 50), 1));
        if (cycle == 200) doomed_.reset();
        if (cycle == 201) {
            EXPECT_TRUE(huge_.closed_by_peer(kPatience)) << "4 GB announced";
        }
        late_.pour(framed(noise(random_, 300)) + framed("(init (unum 2)(teamname " + noise(random_, 300)));
        if (!flood_) flood_ = std::make_unique<RawSocket>(port_);
        for (int i = 0; i < 100 && flood_; ++i) {
            if (!flood_->pour(flood_bytes_)) flood_.reset();
        }
        floods_ended_ += flood_ ? 0 : 1;
    } catch (const std::runtime_error&) {
    }

    int connects() const { return connects_; }
    int floods_ended() const { return floods_ended_; }

  private:
    static std::string many(const std::string& frame) {
        std::string all;
        while (all.size() < 32 * 1024) all += frame;
        return all;
    }

    std::uint16_t port_;
    RawSocket slow_reader_, slow_writer_, half_open_, half_frame_, huge_, late_;
    std::unique_ptr<DoomedPeer> doomed_;
    std::unique_ptr<RawSocket> flood_;
    const std::string flood_bytes_ = many(framed("(he1 1)(beam nan inf 1e300)(syn)"));
    RandomStream random_{3, "test", "noise"};
    int connects_ = 0;
    int floods_ended_ = 0;
};

/// One keeper against one taker, both waving all day, with mischief once a cycle.
struct Course {
    int cycles = 0;
    std::string state_hash;
    std::string log;
    std::chrono::duration<double> wall{};
};

using Mischief = std::function<void(int cycle)>;

Course play(const std::function<Mischief(const ServerProcess&)>& strangers) {
    const auto results = std::filesystem::temp_directory_path() /
                         ("k3d-hostile-" + std::to_string(getpid()) + ".jsonl");
    std::filesystem::remove(results);
    const auto begin = std::chrono::steady_clock::now();
    ServerProcess server({"--game", "keepaway", "--pace", "fast", "--keepers", "1", "--takers", "1",
                          "--left-team", "Keepers", "--seed", "5", "--set", "keepaway.limit=2",
                          "--results", results.string()});
    WireAgent agents[2] = {WireAgent(server), WireAgent(server)};
    wire::Percepts percepts;
    for (int i = 0; i < 2; ++i) {
        agents[i].send("(scene rsg/agent/nao/nao.rsg)(syn)");
        EXPECT_TRUE(agents[i].receive(percepts));
        agents[i].send(std::string("(init (unum 1)(teamname ") + (i == 0 ? "Keepers" : "Takers") +
                       "))(syn)");
    }
    Course course;
    Mischief mischief;
    double last[2] = {0.0, 0.0};
    for (;; ++course.cycles) {
        bool open = true;
        for (int i = 0; i < 2 && open; ++i) {
            open = agents[i].receive(percepts);
            if (!open) break;
            if (mischief) {
                EXPECT_NEAR(percepts.time - last[i], 0.02, 1e-9) << "a frame every cycle";
            }
            last[i] = percepts.time;
        }
        if (!open) break;
        // From here on the match runs: mischief must not change it.
        if (course.cycles == 10) mischief = strangers(server);
        if (mischief) mischief(course.cycles);
        const std::string rate = std::to_string(std::sin(0.1 * course.cycles));
        for (WireAgent& agent : agents) {
            agent.send("(lae1 " + rate + ")(rae1 " + rate + ")(he1 " + rate + ")(syn)");
        }
    }
    const auto exit = server.child().wait(kPatience);
    EXPECT_TRUE(exit && exit->code == 0) << server.log();
    std::ifstream file(results);
    std::string line;
    std::getline(file, line);
    course.state_hash = episode::from_line(line).state_hash;
    course.log = server.log();
    course.wall = std::chrono::steady_clock::now() - begin;
    std::filesystem::remove(results);
    return course;
}

int lines_with(const std::string& text, const std::string& part) {
    int count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(Hostile, AMatchTakesTheCourseItWouldTakeWithoutStrangers) {
    const Course quiet = play([](const ServerProcess&) { return Mischief(); });
    EXPECT_GT(quiet.cycles, 250) << "3 s before kick-off, 2 s of play";

    std::unique_ptr<Strangers> to_agents, to_trainers;
    const Course disturbed = play([&](const ServerProcess& server) {
        to_agents = std::make_unique<Strangers>(server.agent_port());
        to_trainers = std::make_unique<Strangers>(server.trainer_port());
        return [&](int cycle) {
            to_agents->act(cycle);
            to_trainers->act(cycle);
        };
    });
    EXPECT_EQ(disturbed.cycles, quiet.cycles);
    EXPECT_EQ(disturbed.state_hash, quiet.state_hash);
    EXPECT_GE(to_agents->connects() + to_trainers->connects(), 10'000);
    EXPECT_GE(to_agents->floods_ended(), 1);
    EXPECT_GE(to_trainers->floods_ended(), 1);
    for (const char* said : {"bytes announced, limit 65536", "in one cycle, limit", "lines about peers left out"}) {
        EXPECT_NE(disturbed.log.find(said), std::string::npos) << said;
    }
    // Two ports, and for each twenty lines a second of comings and goings and as many warnings.
    EXPECT_LT(lines_with(disturbed.log, "\n"), 200 + 100 * disturbed.wall.count())
        << "strangers cannot fill the disk";
}

TEST(Hostile, StrangersOfASoccerMatchHoldNobodyUp) {
    ServerProcess server(fast_with_one_agent({"--hung-agent-s", "600"}));
    WireAgent good(server);
    good.begin_match("Reds");
    WireAgent no_seat(server);
    no_seat.send("(scene rsg/agent/nao/nao.rsg)");
    WireAgent refused(server);
    refused.send("(scene rsg/agent/nao/nao.rsg)(syn)");
    good.step();
    refused.send("(init (unum 1)(teamname Reds))(syn)");
    double time = good.step().time;
    for (int i = 0; i < 50; ++i, time += 0.02) EXPECT_NEAR(good.step().time, time + 0.02, 1e-9);
}

TEST(Hostile, WhoNeverTakesASeatIsDisconnected) {
    // The seat must be ours before that, and this machine may have much to do.
    ServerProcess server({"--pace", "sync", "--set", "network.handshake=6"});
    WireAgent good(server);
    good.join(1, "Reds");
    RawSocket silent(server.agent_port());
    RawSocket robot_only(server.agent_port());
    robot_only.write(framed("(scene rsg/agent/nao/nao.rsg)"));
    // Who is late is found out in a cycle, and cycles wait for the good one.
    for (RawSocket* late : {&silent, &robot_only}) {
        const auto deadline = std::chrono::steady_clock::now() + kPatience;
        bool gone = false;
        while (!gone && std::chrono::steady_clock::now() < deadline) {
            good.step();
            gone = late->closed_by_peer(std::chrono::milliseconds(1));
        }
        EXPECT_TRUE(gone);
    }
    good.step();
    EXPECT_EQ(lines_with(server.log(), "left: no seat after"), 2) << server.log();
}

TEST(Hostile, ConnectionsBeyondTheLimitAreRefusedByName) {
    ServerProcess server({"--pace", "sync", "--set", "network.max_connections=2"});
    WireAgent good(server);
    good.join(1, "Reds");
    RawSocket second(server.agent_port());
    RawSocket third(server.agent_port());
    EXPECT_TRUE(third.closed_by_peer(kPatience));
    good.step();
    EXPECT_NE(server.log().find("refused: 2 connections open, limit 2"), std::string::npos)
        << server.log();
}

TEST(Hostile, ATrainerCannotBreakThePhysicsUnnoticed) {
    ServerProcess server({"--pace", "sync"});
    WireAgent good(server);
    good.join(1, "Reds");
    RawSocket trainer(server.trainer_port());
    trainer.write(framed("(ball (pos 1e300 0 0))(ball (vel nan 0 0))(agent (unum 1)(team Left)(pos inf 0 1))"));
    for (int i = 0; i < 10; ++i) {
        for (const auto& angle : good.step("(he1 1e300)(he2 inf)(lle1 nan)(beam 1e300 nan 0)").joints_deg) {
            EXPECT_TRUE(std::isfinite(angle) && std::abs(angle) < 360.0);
        }
    }
    EXPECT_NE(server.log().find("3 unknown or damaged"), std::string::npos) << server.log();
    EXPECT_EQ(server.log().find("diverged"), std::string::npos);
}

}  // namespace
}  // namespace k3d::testing
