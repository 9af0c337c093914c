// SPDX-License-Identifier: BSD-3-Clause
// Whole matches: k3d-optimizer starts a server and agents, five robots play, lines come out.
// Episodes are deterministic, so what is expected here holds on every run or on none.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "common/episode/result.h"
#include "common/process/child.h"

namespace k3d::testing {
namespace {

using Flags = std::vector<std::string>;
constexpr std::chrono::minutes kMatchPatience{9};  // less than ctest's, to say what was amiss

class Match : public ::testing::Test {
  protected:
    Match() {
        folder_ = std::filesystem::temp_directory_path() /
                  ("k3d-match-" + std::to_string(getpid()) + "-" +
                   ::testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    ~Match() override {
        if (!HasFailure()) std::filesystem::remove_all(folder_);
    }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }

    process::Child start(const std::string& name, Flags flags) {
        process::Spawn spawn;
        spawn.arguments = {std::string(K3D_BIN_DIR) + "/k3d-optimizer", "match",     "--pace",
                           "fast",      "--results", file(name + ".jsonl")};
        spawn.arguments.insert(spawn.arguments.end(), flags.begin(), flags.end());
        spawn.log_file = file(name + ".log");
        return process::Child(spawn);
    }

    /// Plays and returns the lines; the program must end with `code`.
    std::vector<std::string> play(const std::string& name, Flags flags, int code = 0) {
        process::Child child = start(name, std::move(flags));
        const auto exit = child.wait(kMatchPatience);
        EXPECT_TRUE(exit) << "still running";
        if (exit) {
            EXPECT_EQ(exit->code, code) << text(name + ".log");
        }
        std::vector<std::string> lines;
        std::ifstream in(file(name + ".jsonl"));
        for (std::string line; std::getline(in, line);) lines.push_back(line);
        return lines;
    }

    std::string text(const std::string& name) const {
        std::stringstream all;
        all << std::ifstream(file(name)).rdbuf();
        return all.str();
    }

    std::filesystem::path folder_;
};

/// Ten seconds of play at the most, to keep tests short that do not look at how well it is played.
const Flags kShort{"--set", "server:keepaway.limit=6"};

Flags operator+(Flags a, const Flags& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

TEST_F(Match, EachEpisodeHasSixProcessesOfItsOwn) {
    std::ofstream programs(file("programs.toml"));
    for (const std::string name : {"server", "agent"}) {
        const std::string wrapper = file(name);
        std::ofstream(wrapper) << "#!/bin/sh\necho $$ >> " << wrapper << ".pids\nexec " K3D_BIN_DIR
                               << "/k3d-" << name << " \"$@\"\n";
        std::filesystem::permissions(wrapper, std::filesystem::perms::owner_all);
        programs << name << "_program = \"" << wrapper << "\"\n";
    }
    programs.close();
    const auto lines = play(
        "six", Flags{"--episodes", "2", "--seed", "5", "--config", file("programs.toml")} + kShort);
    EXPECT_EQ(lines.size(), 2U);
    const auto started = [&](const std::string& name) {
        std::istringstream pids(text(name + ".pids"));
        return std::set<int>(std::istream_iterator<int>(pids), {});
    };
    EXPECT_EQ(started("server").size(), 2U) << "fresh for each of the two episodes";
    EXPECT_EQ(started("agent").size(), 10U);
}

TEST_F(Match, SameSeedSameLinesWhateverTheJobsAndProcessesAndAnotherSeedOthers) {
    const Flags flags = Flags{"--episodes", "3"} + kShort;
    const auto one = play("one", flags + Flags{"--seed", "11", "--jobs", "1"});
    const auto two = play("two", flags + Flags{"--seed", "11", "--jobs", "2"});
    const auto shared = play("shared", flags + Flags{"--seed", "11", "--one-process"});
    const auto other = play("other", flags + Flags{"--seed", "71", "--jobs", "2"});
    ASSERT_EQ(one.size(), 3U);
    ASSERT_EQ(other.size(), 3U);
    EXPECT_EQ(one, two);
    EXPECT_EQ(one, shared) << "five agents in one process";
    std::set<std::string> hashes;
    for (const auto& lines : {one, other}) {
        for (const std::string& line : lines) hashes.insert(episode::from_line(line).state_hash);
    }
    EXPECT_EQ(hashes.size(), 6U) << "every seed has a course of its own";
}

TEST_F(Match, KeepersHoldTheBallLongerThanTheyWouldByStandingStill) {
    const Flags flags{"--episodes", "4", "--seed", "1", "--jobs", "2"};
    double hold = 0.0, still = 0.0;
    int kicks = 0, falls = 0;
    for (const std::string& line : play("play", flags)) {
        const episode::Result result = episode::from_line(line);
        EXPECT_TRUE(result.status == episode::Status::Finished ||
                    result.status == episode::Status::Truncated) << line;
        ASSERT_TRUE(result.attempts);
        hold += result.hold_time_s;
        kicks += result.kicks;
        for (const auto& player : result.players) falls += player.falls;
    }
    for (const std::string& line : play("still", flags + Flags{"--keeper-policy", "still"})) {
        const episode::Result result = episode::from_line(line);
        EXPECT_EQ(result.reason, "taker_reached_ball") << line;
        still += result.hold_time_s;
    }
    EXPECT_GE(hold, 1.5 * still);
    EXPECT_GE(kicks, 4) << "one an episode";
    EXPECT_LE(falls, 5.0 * hold / 60.0 + 1.0) << "one per player and minute";
}

TEST_F(Match, BenchPrintsWhatEachStageAndStepperCosts) {
    process::Spawn spawn;
    spawn.arguments = {std::string(K3D_BIN_DIR) + "/k3d-optimizer", "bench", "--episodes", "1",
                       "--limit-s", "2", "--keepers", "1", "--takers", "1"};
    spawn.log_file = file("bench.log");
    process::Child child(spawn);
    const auto exit = child.wait(kMatchPatience);
    const std::string said = text("bench.log");
    ASSERT_TRUE(exit && exit->code == 0) << said;
    for (const char* row : {"simulated s per core-s", "server, physics", "server, collision",
                            "server, percepts", "server, wire", "2 agents", "episode of 1 s"}) {
        EXPECT_NE(said.find(row), std::string::npos) << said;
    }
    const auto at = said.find("  server, physics") + std::string("  server, physics").size();
    double exact = 0.0, fast = 0.0;
    std::istringstream(said.substr(at)) >> exact >> fast;
    EXPECT_GT(exact, 0.0) << said;
    EXPECT_GT(fast, 0.0) << said;
}

TEST_F(Match, ForeignProgramsTakeAnySeatAndSeeNoGroundTruth) {
    const std::string recorder = std::string(K3D_BIN_DIR) + "/frame_recorder {host} {port} {unum} "
                                 "{team} " + file("frames");
    const auto lines = play("foreign", Flags{"--episodes", "1", "--taker-command", recorder} + kShort);
    ASSERT_EQ(lines.size(), 1U);
    for (const char* taker : {"1", "2"}) {
        const std::string frames = text(std::string("frames.Takers.") + taker);
        EXPECT_GT(frames.size(), 100000U);
        EXPECT_NE(frames.find("(See "), std::string::npos);
        for (const char* truth : {"mypos", "myorien", "ballpos"}) {
            EXPECT_EQ(frames.find(truth), std::string::npos) << truth;
        }
    }
}

TEST_F(Match, AgentThatDiesGivesAgentLostAndAnExitCode) {
    const auto lines = play("dies", Flags{"--episodes", "1", "--retries", "0", "--lobby-s", "5",
                                          "--taker-command", "/bin/false"}, 1);
    // Both takers die, and which death is noticed first, or whether the empty seat is, is a
    // matter of timing: each of the four gives its own true line.
    const std::string said = text("dies.log");
    const bool named = std::ranges::any_of(
        std::array{"taker 1: exit code 1", "taker 2: exit code 1", "right 1", "right 2"},
        [&](const char* clue) { return said.find(clue) != std::string::npos; });
    EXPECT_TRUE(named) << said;
    EXPECT_NE(said.find("episodes with a valid result: 0 of 1"), std::string::npos) << said;
    for (const std::string& line : lines) {
        EXPECT_EQ(episode::from_line(line).status, episode::Status::AgentLost);
    }
}

}  // namespace
}  // namespace k3d::testing
