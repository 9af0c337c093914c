// SPDX-License-Identifier: BSD-3-Clause
// Drills as a user starts them: optimizer, server and agent over real sockets.
#include <gmock/gmock.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "common/episode/result.h"
#include "integration/server_process.h"

namespace k3d::testing {
namespace {

using ::testing::HasSubstr;

class Drills : public ::testing::Test {
  protected:
    Drills()
        : folder_(std::filesystem::temp_directory_path() /
                  ("k3d-drill-" + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder_);
    }
    ~Drills() override { std::filesystem::remove_all(folder_); }

    /// Runs it to its end; what it printed stays in said().
    int run(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {K3D_BIN_DIR "/k3d-optimizer", "drill"});
        process::Child child({arguments, file("said"), false});
        const auto exit = child.wait(std::chrono::minutes(2));
        return exit ? exit->code : -1;
    }
    std::string file(const std::string& name) const { return (folder_ / name).string(); }
    std::string content(const std::string& name) const {
        std::ifstream in(file(name));
        return {std::istreambuf_iterator<char>(in), {}};
    }

    std::filesystem::path folder_;
};

TEST_F(Drills, TheSameSeedGivesTheSameLines) {
    for (const char* name : {"first", "second"}) {
        ASSERT_EQ(run({"kick", "--runs", "2", "--seed", "3", "--results", file(name)}), 0)
            << content("said");
    }
    EXPECT_EQ(content("first"), content("second"));
    std::ifstream lines(file("first"));
    int runs = 0;
    for (std::string line; std::getline(lines, line); ++runs) {
        const episode::Result result = episode::from_line(line);
        EXPECT_EQ(result.game, "drill_kick");
        EXPECT_EQ(result.seed, 3U + static_cast<unsigned>(runs));
        EXPECT_EQ(result.reason, "done") << line;
        EXPECT_EQ(result.attempts, 1);
        EXPECT_GT(result.metrics.at("distance_m"), 3.0) << line;
        EXPECT_LT(result.metrics.at("position_error_m"), 0.1) << line;
        EXPECT_LT(result.metrics.at("ball_error_percent"), 5.0) << line;
    }
    EXPECT_EQ(runs, 2);
    EXPECT_THAT(content("said"), HasSubstr("direction_error_deg             2"));
}

TEST_F(Drills, AFallenRobotIsMeasuredGettingUp) {
    ASSERT_EQ(run({"getup", "--results", file("lines"), "--runs", "1"}), 0) << content("said");
    const episode::Result result = episode::from_line(content("lines"));
    EXPECT_EQ(result.reason, "done");
    EXPECT_EQ(result.metrics.at("falls"), 1.0);
    EXPECT_GT(result.metrics.at("up_after_s"), 0.5);
}

TEST_F(Drills, ASecondRobotKicksABallWhoseStopIsForeseen) {
    ASSERT_EQ(run({"ball_rolls", "--results", file("lines"), "--seed", "1001", "--runs", "1",
                   "--set", "server:physics.stepper=fast"}),
              0)
        << content("said");
    const episode::Result result = episode::from_line(content("lines"));
    EXPECT_EQ(result.reason, "done");
    EXPECT_EQ(result.attempts, 0) << "the robot that is measured only watches";
    EXPECT_GT(result.metrics.at("rolled_m"), 2.5);
    EXPECT_LT(result.metrics.at("kicked_error_1.5s_m"), 0.3);
}

TEST_F(Drills, AServerThatRunsAlreadyIsUsed) {
    // It waits for the agent: in real time one that gets no processor falls.
    ServerProcess server({"--pace", "sync"});
    ASSERT_EQ(run({"turn", "--runs", "1", "--set", "setup.turn_s=1.5", "--agent-port",
                   std::to_string(server.agent_port()), "--server-port",
                   std::to_string(server.trainer_port()), "--results", file("lines")}),
              0)
        << content("said");
    const episode::Result result = episode::from_line(content("lines"));
    EXPECT_GT(std::abs(result.metrics.at("turn_deg_per_s")), 30.0);
    EXPECT_FALSE(server.child().poll()) << "it is not ours to end";
}

TEST_F(Drills, AStopEndsARunAndShowsThoseBefore) {
    const std::string temporary = file("tmp");
    std::filesystem::create_directory(temporary);
    ::setenv("TMPDIR", temporary.c_str(), 1);
    process::Child child({{K3D_BIN_DIR "/k3d-optimizer", "drill", "turn", "--runs", "1000", "--set",
                           "setup.turn_s=1.5", "--results", file("lines")},
                          file("said"),
                          false});
    ::unsetenv("TMPDIR");
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    while (content("lines").empty() && std::chrono::steady_clock::now() < deadline) {
        ASSERT_FALSE(child.wait(std::chrono::milliseconds(20))) << content("said");
    }
    ::kill(child.pid(), SIGTERM);
    const auto exit = child.wait(std::chrono::minutes(1));
    ASSERT_TRUE(exit);
    EXPECT_EQ(exit->code, 130) << content("said");
    EXPECT_THAT(content("said"), HasSubstr("drill turn, type 0, seeds 1 to 1000\n"));
    EXPECT_THAT(content("said"), HasSubstr(" of 1000\n"));
    EXPECT_TRUE(std::filesystem::is_empty(temporary)) << "nothing has failed";
}

TEST_F(Drills, OnlyWhatAllRunsWouldMeetEndsThemAtTheFirst) {
    EXPECT_EQ(run({"walk", "--runs", "2", "--set", "agent_program=/bin/false"}), 1);
    EXPECT_THAT(content("said"), HasSubstr("run 2, seed 2: the agent has left"));
    EXPECT_THAT(content("said"), HasSubstr("runs with a valid result: 0 of 2"));
    std::ofstream(file("lines")) << "of another day\n";
    EXPECT_EQ(run({"walk", "--set", "agent:motion.wlak=3", "--results", file("lines")}), 2);
    EXPECT_EQ(run({"walk", "--set", "server_program=/bin/false", "--results", file("lines")}), 1);
    EXPECT_THAT(content("said"), ::testing::Not(HasSubstr("run 2")));
    EXPECT_EQ(content("lines"), "of another day\n");
}

TEST_F(Drills, WhatCannotBeDrilledIsNamed) {
    EXPECT_EQ(run({"juggle"}), 2);
    EXPECT_THAT(content("said"), HasSubstr("juggle"));
    EXPECT_EQ(run({"walk", "--set", "setup.walk_km=3"}), 2);
    EXPECT_THAT(content("said"), HasSubstr("walk_km"));
    EXPECT_EQ(run({"walk", "--agent-port", "3100"}), 2);
    EXPECT_THAT(content("said"), HasSubstr("server_port"));
    EXPECT_EQ(run({"walk", "--set", "agent:motion.wlak=3"}), 2);
    EXPECT_THAT(content("said"), HasSubstr("wlak"));
    EXPECT_EQ(run({"walk", "--set", "server:physics.steper=fast"}), 2);
    EXPECT_THAT(content("said"), HasSubstr("steper"));
    EXPECT_EQ(run({"walk", "--pace", "sync", "--agent-port", "3100", "--server-port", "3200"}), 2);
    EXPECT_THAT(content("said"), HasSubstr("not told pace sync"));
    EXPECT_EQ(run({"walk", "--set", "server_program=/nowhere/server"}), 3);
    EXPECT_THAT(content("said"), HasSubstr("cannot start /nowhere/server"));
}

}  // namespace
}  // namespace k3d::testing
