// SPDX-License-Identifier: BSD-3-Clause
// Ctrl-C ends a server whatever it waits for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "integration/server_process.h"

namespace k3d::testing {
namespace {

using ::testing::HasSubstr;

/// Exit code and output of `k3d-server replay`.
std::pair<int, std::string> replayed(const std::string& recording) {
    process::Spawn spawn;
    spawn.arguments = {std::string(K3D_BIN_DIR) + "/k3d-server", "replay", recording};
    spawn.log_file = recording + ".log";
    process::Child child(spawn);
    const auto exit = child.wait(kPatience);
    std::stringstream text;
    text << std::ifstream(spawn.log_file).rdbuf();
    std::filesystem::remove(spawn.log_file);
    return {exit ? exit->code : -1, text.str()};
}

TEST(Stop, IsHeardWhileAnAgentIsWaitedForAndWhatWasPlayedReplays) {
    const std::string recording =
        (std::filesystem::temp_directory_path() / ("k3d-stop-" + std::to_string(getpid()) + ".rec"))
            .string();
    for (const int signal : {SIGINT, SIGTERM}) {
        ServerProcess server({"--pace", "sync", "--hung-agent-s", "600", "--record", recording});
        WireAgent agent(server);
        agent.join(1, "Reds");
        for (int i = 0; i < 20; ++i) agent.step("(rae1 1)");
        agent.send("(rae1 -1)");  // no (syn): its answer is incomplete, for ten minutes
        // Time to come to the wait; on a machine that needs more the signal is heard before it.
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        ::kill(server.child().pid(), signal);
        const auto exit = server.child().wait(kPatience);
        ASSERT_TRUE(exit) << "still waiting after signal " << signal;
        EXPECT_EQ(exit->code, 0) << server.log();
        const auto [code, text] = replayed(recording);
        EXPECT_EQ(code, 0) << text;
        EXPECT_THAT(text, HasSubstr("replay equal\n"));
        std::filesystem::remove(recording);
    }
}

}  // namespace
}  // namespace k3d::testing
