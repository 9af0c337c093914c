// SPDX-License-Identifier: BSD-3-Clause
// Files that a server is asked to write and cannot: it ends, and says which and why.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "integration/puppets.h"

namespace k3d::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Exit code and output of a server with these flags that ends by itself.
std::pair<int, std::string> ended(const std::vector<std::string>& flags) {
    std::vector<std::string> all{"--agent-port", "0", "--server-port", "0"};
    all.insert(all.end(), flags.begin(), flags.end());
    return run_to_end("k3d-server", all);
}

TEST(Outputs, AreOpenedBeforeAnybodyIsServed) {
    const std::string reason = "/no/such/folder/x.jsonl: No such file or directory\n";
    for (const auto& [flags, what] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"--results", "/no/such/folder/x.jsonl"}, "results"},
             {{"--set", "stage_times=/no/such/folder/x.jsonl"}, "stage times"}}) {
        const auto [code, text] = ended(flags);
        EXPECT_EQ(code, 1) << what;
        EXPECT_THAT(text, HasSubstr("k3d-server: cannot write " + what + " to " + reason));
        EXPECT_THAT(text, Not(HasSubstr("ready")));
    }
}

TEST(Outputs, OnADiskThatIsFullEndTheRun) {
    PuppetGame game("full", {"--episodes", "3"}, always, "/dev/full");
    game.turns(10);
    game.turn("(ball (pos 8 0 0.042))");
    EXPECT_EQ(game.play_to_the_end(), 1);
    EXPECT_THAT(game.server().log(), HasSubstr(": No space left on device"));
    EXPECT_THAT(game.server().log(), Not(HasSubstr("keepaway 2 of 3")));

    PuppetGame measured("full-times", {"--set", "stage_times=/dev/full"});
    measured.turns(10);
    measured.turn("(ball (pos 8 0 0.042))");
    EXPECT_EQ(measured.play_to_the_end(), 1);
    EXPECT_THAT(measured.server().log(), HasSubstr("cannot write stage times to /dev/full"));
    EXPECT_EQ(measured.results().size(), 1U);
}

TEST(Outputs, HoldNoLogLinesOfAServerWhoseStandardStreamsAreClosed) {
    const auto results = std::filesystem::temp_directory_path() /
                         ("k3d-output-" + std::to_string(getpid()) + ".jsonl");
    std::filesystem::remove(results);
    process::Spawn spawn;
    spawn.arguments = {"/bin/sh",
                       "-c",
                       R"(exec "$0" "$@" <&- 2>&-)",
                       std::string(K3D_BIN_DIR) + "/k3d-server",
                       "--agent-port",
                       "0",
                       "--server-port",
                       "0",
                       "--game",
                       "keepaway",
                       "--lobby-s",
                       "0.1",
                       "--results",
                       results.string()};
    process::Child child(spawn);
    const auto exit = child.wait(kPatience);
    EXPECT_TRUE(exit && exit->code == 3) << "nobody came to play";
    EXPECT_EQ(std::filesystem::file_size(results), 0U);
    std::filesystem::remove(results);
}

}  // namespace
}  // namespace k3d::testing
