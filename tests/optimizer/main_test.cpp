// SPDX-License-Identifier: BSD-3-Clause
// k3d-optimizer as a program: flags, exit codes, one clear line for each mistake.
#include <gmock/gmock.h>

#include "common/process/child.h"
#include "tests/optimizer/fake_programs.h"

namespace k3d::optimizer {
namespace {

using testing::HasSubstr;
using testing::Not;

class Program : public FakePrograms {
  protected:
    /// Runs it to its end, or 30 s, and keeps what it printed.
    int run(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), K3D_BIN_DIR "/k3d-optimizer");
        const std::string log = base_ + "/said";
        process::Child child({arguments, log, false});
        const auto exit = child.wait(std::chrono::seconds(30));
        said_ = content(log);
        return exit ? exit->code : -1;
    }

    /// The same for `match` with the scripts in place of the server and the agents.
    int match(std::vector<std::string> arguments) {
        std::ofstream(base_ + "/match.toml")
            << "server_program = \"" << base_ << "/server\"\nagent_program = \"" << base_
            << "/agent\"\nkeepers = 2\ntakers = 1\n";
        const std::vector<std::string> first{"match", "--config", base_ + "/match.toml"};
        arguments.insert(arguments.begin(), first.begin(), first.end());
        return run(arguments);
    }

    std::string said_;
};

TEST_F(Program, PlaysAndPrintsATable) {
    EXPECT_EQ(match({"--episodes", "2", "--jobs", "2", "--seed", "5", "--results", spec_.results}),
              0)
        << said_;
    EXPECT_THAT(said_, HasSubstr("2 keepers against 1 takers (greedy), fast pace, seeds 5 to 6"));
    EXPECT_THAT(said_, HasSubstr("hold time, s       2     6.00     0.71     0.50"));
    const std::string lines = content(spec_.results);
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 2);
}

TEST_F(Program, AnEpisodeWithoutResultIsAFailure) {
    server_plays("status=diverged; result >> $results");
    EXPECT_EQ(match({"--retries", "0"}), 1);
    EXPECT_THAT(said_, HasSubstr("given up"));
    EXPECT_THAT(said_, HasSubstr("episodes with a valid result: 0 of 1"));
}

TEST_F(Program, MistakesOnTheCommandLineAreNamed) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> mistakes{
        {{}, "which subcommand?"},
        {{"mach"}, "mach"},
        {{"match", "--epsiodes", "2"}, "--epsiodes"},
        {{"match", "--episodes", "0"}, "episodes"},
        {{"match", "--episodes", "two"}, "two"},
        {{"match", "--taker", "lazy"}, "lazy"},
        {{"match", "--http", "70000"}, "70000"},
        {{"match", "--http", "80", "--no-viewer"}, "--http"},
        {{"match", "--config", "/nowhere.toml"}, "/nowhere.toml"},
        {{"match", "--agent-config", "/nowhere.toml"}, "/nowhere.toml"},
        {{"match", "--set", "side=12"}, "'side=12'"},
        {{"match", "--keeper-command", "x {prot}"}, "{prot}"},
    };
    for (const auto& [arguments, names] : mistakes) {
        EXPECT_EQ(run(arguments), 2) << names;
        EXPECT_THAT(said_, HasSubstr(names));
        EXPECT_LE(std::count(said_.begin(), said_.end(), '\n'), 2) << said_;
    }
}

TEST_F(Program, AFileThatCannotBeWrittenIsNamed) {
    EXPECT_EQ(match({"--results", "/nowhere/out.jsonl"}), 1);
    EXPECT_EQ(said_, "k3d-optimizer: cannot write results to /nowhere/out.jsonl\n");
}

TEST_F(Program, ABusyPageIsOneLine) {
    script("server", "echo 'cannot listen on 127.0.0.1:8080: Address already in use' >&2; exit 1");
    EXPECT_EQ(match({"--http", "8080"}), 1);
    EXPECT_THAT(said_, HasSubstr("k3d-optimizer: server: exit code 1: cannot listen on "
                                 "127.0.0.1:8080: Address already in use; logs in "));
    EXPECT_EQ(std::count(said_.begin(), said_.end(), '\n'), 1) << said_;
}

TEST_F(Program, PrintsTheResolvedRun) {
    EXPECT_EQ(match({"--keepers", "4", "--set", "server:a=1", "--set", "agent:b=x y", "--no-viewer",
                     "--print-config"}),
              0);
    EXPECT_THAT(said_, HasSubstr("\nkeepers = 4  #"));
    EXPECT_THAT(said_, HasSubstr("\ntakers = 1  #"));
    EXPECT_THAT(said_, HasSubstr(R"(settings = "\"server:a=1\" \"agent:b=x y\"")"));
    EXPECT_THAT(said_, HasSubstr("http_port = -1"));
}

TEST_F(Program, HelpIsNoMistake) {
    EXPECT_EQ(run({"match", "--help"}), 0);
    EXPECT_THAT(said_, HasSubstr("--keeper-command"));
    EXPECT_EQ(run({"--version"}), 0);
}

}  // namespace
}  // namespace k3d::optimizer
