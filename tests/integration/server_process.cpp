// SPDX-License-Identifier: BSD-3-Clause
#include "integration/server_process.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace k3d::testing {

namespace {

std::string content(const std::string& path) {
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

std::string fresh_log_file() {
    static int count = 0;
    const auto folder = std::filesystem::temp_directory_path();
    return (folder / ("k3d-server-test-" + std::to_string(getpid()) + "-" +
                      std::to_string(++count) + ".log"))
        .string();
}

process::Spawn spawn(std::vector<std::string> flags, const std::string& log_file) {
    process::Spawn s;
    s.arguments = {std::string(K3D_BIN_DIR) + "/k3d-server", "--agent-port", "0", "--server-port",
                   "0"};
    s.arguments.insert(s.arguments.end(), flags.begin(), flags.end());
    s.log_file = log_file;
    s.capture_stdout = true;
    return s;
}

std::uint16_t to_port(const std::string& text) { return static_cast<std::uint16_t>(std::stoi(text)); }

}  // namespace

std::vector<std::string> fast_with_one_agent(std::vector<std::string> more) {
    std::vector<std::string> flags{"--pace", "fast", "--set", "pace.lobby_left=1"};
    flags.insert(flags.end(), more.begin(), more.end());
    return flags;
}

std::pair<int, std::string> run_to_end(const std::string& program, std::vector<std::string> flags) {
    const std::string log = fresh_log_file();
    flags.insert(flags.begin(), std::string(K3D_BIN_DIR) + "/" + program);
    process::Child child({std::move(flags), log, false});
    const auto exit = child.wait(kPatience);
    const std::string text = content(log);
    std::filesystem::remove(log);
    return {exit ? exit->code : -1, text};
}

ServerProcess::ServerProcess(std::vector<std::string> flags)
    : log_file_(fresh_log_file()), child_(spawn(std::move(flags), log_file_)) {
    const auto ready = child_.wait_ready(kPatience);
    agent_port_ = to_port(ready.at("agent"));
    trainer_port_ = to_port(ready.at("monitor"));
}

ServerProcess::~ServerProcess() {
    if (!::testing::Test::HasFailure()) std::filesystem::remove(log_file_);
}

std::string ServerProcess::log() const {
    return content(log_file_);
}

bool WireAgent::receive(wire::Percepts& percepts, std::chrono::milliseconds patience) {
    std::string_view frame;
    if (!client_.receive(frame, patience)) return false;
    payload_ = frame;
    EXPECT_EQ(wire::decode(frame, percepts), 0) << frame;
    return true;
}

wire::Percepts WireAgent::join(int unum, const std::string& team, int type) {
    wire::Percepts percepts;
    send("(scene rsg/agent/nao/nao_hetero.rsg " + std::to_string(type) + ")(syn)");
    EXPECT_TRUE(receive(percepts));
    percepts = step("(init (unum " + std::to_string(unum) + ")(teamname " + team + "))");
    for (int i = 0; i < kMostFramesToSeat && !percepts.game->unum; ++i) percepts = step();
    if (!percepts.game->unum) ADD_FAILURE() << "no seat within " << kMostFramesToSeat << " frames";
    return percepts;
}

void WireAgent::begin_match(const std::string& team) {
    join(1, team);
    // The lobby gives five answers, one for each frame, and the match begins with the sixth frame.
    constexpr int kLobbyPercepts = 5;
    constexpr int kOfJoin = 2;
    for (int i = kOfJoin; i < kLobbyPercepts + 1; ++i) step();
}

wire::Percepts WireAgent::step(const std::string& commands) {
    wire::Percepts percepts;
    send(commands + "(syn)");
    EXPECT_TRUE(receive(percepts)) << "the server closed the connection";
    return percepts;
}

}  // namespace k3d::testing
