// SPDX-License-Identifier: BSD-3-Clause
// Several episodes with the same processes: server and agents begin each one anew.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "common/episode/result.h"
#include "integration/server_process.h"

namespace k3d::testing {
namespace {

process::Child start_agent(const ServerProcess& server, const char* team, int unum) {
    process::Spawn spawn;
    spawn.arguments = {std::string(K3D_BIN_DIR) + "/k3d-agent",
                       "--port", std::to_string(server.agent_port()),
                       "--team", team,
                       "--unum", std::to_string(unum),
                       "--log-level", "off"};
    return process::Child(spawn);
}

TEST(Episodes, OneServerAndFiveAgentsPlaySeveral) {
    const auto results = std::filesystem::temp_directory_path() /
                         ("k3d-episodes-" + std::to_string(getpid()) + ".jsonl");
    std::filesystem::remove(results);
    ServerProcess server({"--game", "keepaway", "--pace", "fast", "--episodes", "3", "--seed", "20",
                          "--left-team", "Keepers", "--set", "keepaway.limit=8", "--results",
                          results.string()});
    std::vector<process::Child> agents;
    for (int unum = 1; unum <= 3; ++unum) agents.push_back(start_agent(server, "Keepers", unum));
    for (int unum = 1; unum <= 2; ++unum) agents.push_back(start_agent(server, "Takers", unum));
    const auto exit = server.child().wait(std::chrono::minutes(5));
    ASSERT_TRUE(exit) << "still running";
    EXPECT_EQ(exit->code, 0) << server.log();
    for (process::Child& agent : agents) {
        const auto left = agent.wait(kPatience);
        ASSERT_TRUE(left);
        EXPECT_EQ(left->code, 0) << "the server closed in order";
    }
    std::ifstream file(results);
    std::uint64_t seed = 20;
    for (std::string line; std::getline(file, line); ++seed) {
        const episode::Result result = episode::from_line(line);
        EXPECT_EQ(result.seed, seed);
        EXPECT_GE(result.hold_time_s, 5.0) << "takers need longer than that: " << line;
        EXPECT_GE(result.players.at(3).distance_m, 1.0) << "takers walk in every episode";
    }
    EXPECT_EQ(seed, 23U);
    std::filesystem::remove(results);
}

}  // namespace
}  // namespace k3d::testing
