// SPDX-License-Identifier: BSD-3-Clause
// Recordings of real runs, re-simulated by `k3d-server replay`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <sstream>
#include <thread>

#include "integration/duel.h"
#include "server/recording/record_reader.h"
#include "server/recording/record_writer.h"

namespace k3d::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;
namespace rec = server::recording;

class Recording : public ::testing::Test {
  protected:
    Recording() {
        folder_ = std::filesystem::temp_directory_path() /
                  ("k3d-record-" + std::to_string(getpid()) + "-" +
                   ::testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    ~Recording() override {
        if (!HasFailure()) std::filesystem::remove_all(folder_);
    }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }
    static std::string bytes(const std::string& name) {
        std::ifstream in(name, std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    }

    /// Exit code and output of a k3d-server that ends by itself.
    std::pair<int, std::string> ended(const std::vector<std::string>& flags) const {
        process::Spawn spawn;
        spawn.arguments = {std::string(K3D_BIN_DIR) + "/k3d-server"};
        spawn.arguments.insert(spawn.arguments.end(), flags.begin(), flags.end());
        spawn.log_file = file("ended.log");
        process::Child child(spawn);
        const auto exit = child.wait(kPatience);
        EXPECT_TRUE(exit);
        return {exit ? exit->code : -1, bytes(file("ended.log"))};
    }
    std::pair<int, std::string> replay(const std::string& recording,
                                       std::vector<std::string> flags = {}) const {
        flags.insert(flags.begin(), {"replay", recording, "--log-level", "off"});
        return ended(flags);
    }

    std::filesystem::path folder_;
};

TEST_F(Recording, ADuelWithATrainerReplaysWithItsResultAndMonitorLog) {
    const std::string recording = file("duel.rec");
    const episode::Result live =
        play_duel({"--record", recording, "--monitor-log", file("live.log")}, kBallOut, "record");
    const auto [code, text] = replay(
        recording, {"--results", file("again.jsonl"), "--monitor-log", file("again.log")});
    EXPECT_EQ(code, 0);
    EXPECT_THAT(text, HasSubstr("replay equal\n"));
    std::string line = bytes(file("again.jsonl"));
    line.pop_back();
    EXPECT_EQ(line, episode::to_line(live));
    EXPECT_EQ(bytes(file("live.log")), bytes(file("again.log")));
    EXPECT_THAT(bytes(file("live.log")), HasSubstr("(RSG 0 1)"));
}

TEST_F(Recording, AnotherInputIsNoticedInTheCycleInWhichItActs) {
    const std::string recording = file("duel.rec");
    play_duel({"--record", recording}, kBallOut, "forge");
    // The same file but for one trainer command.
    std::ifstream in(recording, std::ios::binary);
    rec::RecordReader reader(in, recording);
    int step = 0;
    int forged_step = 0;
    {
        rec::RecordWriter writer(file("forged.rec"), reader.header());
        while (auto entry = reader.next()) {
            if (auto* received = std::get_if<rec::Received>(&*entry)) {
                if (holds(received->frame, "(ball (pos 8 0 0.042))")) {
                    received->frame = "(ball (pos 8 1e-9 0.042))(syn)";
                    forged_step = step + 1;
                }
                writer.add(received->connection, received->frame);
            } else if (const auto* accepted = std::get_if<rec::Accepted>(&*entry)) {
                writer.add(*accepted);
            } else if (const auto* left = std::get_if<rec::Left>(&*entry)) {
                writer.add(*left);
            } else if (const auto* end = std::get_if<rec::StepEnd>(&*entry)) {
                ++step;
                writer.add(*end);
            }
        }
    }
    ASSERT_GT(forged_step, 0);
    const auto [code, text] = replay(file("forged.rec"));
    EXPECT_EQ(code, 4);
    // The match begins at cycle 5; the frame of cycle 2k + 4 is the trainer's kth, and its answer acts in
    // the cycle after that: what follows the 12th is known at the end of cycle 29.
    EXPECT_THAT(text, HasSubstr("cycle 29 (0.58 s, episode 1) differs from what was recorded"));
}

TEST_F(Recording, ARealTimeRunOfWhoComesAndGoesReplays) {
    const std::string recording = file("soccer.rec");
    ServerProcess server({"--pace", "realtime", "--ground-truth", "--record", recording});
    net::Client trainer("127.0.0.1", server.trainer_port(), kPatience);
    WireAgent stays(server);
    stays.join(2, "Reds", 4);
    trainer.send("(playMode PlayOn)(ball (pos -14 8 0.1)(vel 1 0 2))");
    {
        WireAgent goes(server);
        goes.join(3, "Reds");
        for (int i = 0; i < 10; ++i) goes.step("(lle3 2)(say hello)");
    }
    net::Client("127.0.0.1", server.agent_port(), kPatience).send("garbage((");
    for (int i = 0; i < 30; ++i) stays.step("(rle3 1)(rae1 -1)(he1 0.3)");
    trainer.send("(agent (unum 2)(team Left)(move 0 0 0.5 30))(score (left 2)(right 1))");
    for (int i = 0; i < 30; ++i) stays.step("(lle4 -1)");
    trainer.send("(kill (unum 2)(team Left))");
    trainer.send("(killsim)");
    const auto exit = server.child().wait(kPatience);
    ASSERT_TRUE(exit && exit->code == 0);
    const auto [code, text] = replay(recording);
    EXPECT_EQ(code, 0) << text;
    EXPECT_THAT(text, MatchesRegex(".*all [0-9]+ steps up to cycle [0-9]+ .* replay equal\n"));
}

TEST_F(Recording, WhatAKilledServerLeavesReplays) {
    const std::string recording = file("killed.rec");
    ServerProcess server(fast_with_one_agent({"--record", recording}));
    WireAgent agent(server);
    agent.begin_match("Reds");
    for (int i = 0; i < 200; ++i) agent.step("(rae1 1)");
    ::kill(server.child().pid(), SIGKILL);
    server.child().wait(kPatience);
    const auto [code, text] = replay(recording);
    EXPECT_EQ(code, 0) << text;
    EXPECT_THAT(text, HasSubstr("replay equal; the recording has no end, its server was killed"));
}

TEST_F(Recording, IsLeftWholeByASecondStartOnTheSamePort) {
    const std::vector<std::string> files{"--record", file("match.rec"), "--monitor-log",
                                         file("match.log")};
    ServerProcess server(fast_with_one_agent(files));
    WireAgent agent(server);
    agent.begin_match("Reds");
    for (int i = 0; i < 50; ++i) agent.step("(rae1 1)");
    std::vector<std::string> flags{"--agent-port", std::to_string(server.agent_port()),
                                   "--server-port", "0"};
    flags.insert(flags.end(), files.begin(), files.end());
    const auto [second_code, second] = ended(flags);
    EXPECT_EQ(second_code, 1);
    EXPECT_THAT(second, HasSubstr("Address already in use"));
    for (int i = 0; i < 50; ++i) agent.step("(rae1 -1)");
    ::kill(server.child().pid(), SIGTERM);
    const auto exit = server.child().wait(kPatience);
    ASSERT_TRUE(exit && exit->code == 0);
    const auto [code, text] = replay(file("match.rec"));
    EXPECT_EQ(code, 0) << text;
    EXPECT_THAT(bytes(file("match.log")), HasSubstr("(RSG 0 1)"));
}

TEST_F(Recording, NoFlagOfAReplayIsIgnoredOrOverwritesIt) {
    const std::string recording = file("any.rec");
    std::ofstream(recording) << "whatever it holds\n";
    for (const auto& [flags, why] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"--seed", "3", "replay", recording}, "--seed: no flag may stand before replay"},
             {{"--noise", "off", "replay", recording}, "--noise: no flag may stand before replay"},
             {{"--record", recording, "replay", recording}, "--record: no flag may stand before"},
             {{"replay", recording, "--results", recording}, "--results: " + recording},
             {{"replay", recording, "--monitor-log", recording}, "--monitor-log: " + recording}}) {
        const auto [code, text] = ended(flags);
        EXPECT_EQ(code, 2);
        EXPECT_THAT(text, HasSubstr("k3d-server: " + why));
        EXPECT_EQ(bytes(recording), "whatever it holds\n");
    }
}

TEST_F(Recording, ADamagedFileIsNamedWithThePlace) {
    const std::string recording = file("duel.rec");
    play_duel({"--record", recording}, kBallOut, "damage");
    std::string damaged = bytes(recording);
    damaged.resize(damaged.size() - 5);
    std::ofstream(file("cut.rec"), std::ios::binary) << damaged;
    const auto [cut_code, cut] = replay(file("cut.rec"));
    EXPECT_EQ(cut_code, 5);
    EXPECT_THAT(cut, MatchesRegex("k3d-server: .*/cut.rec: block at byte [0-9]+: cut short: [0-9]+ of "
                                  "[0-9]+ bytes of a block \\(the [0-9]+ steps before it replay "
                                  "equal\\)\n"));
    std::ofstream(file("text.rec")) << "no recording\n";
    const auto [text_code, text] = replay(file("text.rec"));
    EXPECT_EQ(text_code, 5);
    EXPECT_THAT(text, HasSubstr("text.rec: is no recording"));
    const auto [missing_code, missing] = replay(file("missing.rec"));
    EXPECT_EQ(missing_code, 2);
    EXPECT_THAT(missing, HasSubstr("File does not exist: " + file("missing.rec")));
}

}  // namespace
}  // namespace k3d::testing
