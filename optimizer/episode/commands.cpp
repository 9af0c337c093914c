// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/episode/commands.h"

#include <fmt/format.h>

#include <utility>

#include "common/net/net.h"
#include "optimizer/spec/ask.h"
#include "optimizer/spec/settings.h"
#include "optimizer/spec/words.h"

namespace k3d::optimizer::episode {

namespace {

constexpr const char* kHost = "127.0.0.1";
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

void add(std::vector<std::string>& words, const char* flag, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {flag, value});
}

void add_all(std::vector<std::string>& words, const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) add(words, "--set", setting);
}

}  // namespace

std::string Seat::name() const {
    return fmt::format("{} {}", keeper ? "keeper" : "taker", unum);
}
std::string Seat::file_stem() const {
    return fmt::format("{}-{}", keeper ? "keeper" : "taker", unum);
}
std::string Seat::team() const {
    return keeper ? "Keepers" : "Takers";
}

std::vector<Seat> seats(const spec::MatchSpec& spec) {
    std::vector<Seat> all;
    for (int unum = 1; unum <= spec.keepers; ++unum) all.push_back({true, unum});
    for (int unum = 1; unum <= spec.takers; ++unum) all.push_back({false, unum});
    return all;
}

bool is_foreign(const spec::MatchSpec& spec, const Seat& seat) {
    return !(seat.keeper ? spec.keeper_command : spec.taker_command).empty();
}

std::string result_file(const std::string& folder) {
    return folder + "/result.jsonl";
}

std::string telemetry_file(const std::string& folder, const Seat& seat) {
    return fmt::format("{}/{}.telemetry.jsonl", folder, seat.file_stem());
}

std::string agent_socket(const std::string& folder) {
    std::string path = folder + "/agents";
    return path.size() <= net::kMaxUnixPath ? path : "";
}

std::vector<std::string> server_command(const spec::MatchSpec& spec, const Task& task,
                                        const std::string& folder, int http_port) {
    std::vector<std::string> words{spec::program_path(spec.server_program, "k3d-server"),
                                   "--game",
                                   "keepaway",
                                   "--pace",
                                   spec.pace,
                                   "--seed",
                                   std::to_string(task.seed),
                                   "--episodes",
                                   "1",
                                   "--agent-port",
                                   "0",
                                   "--server-port",
                                   "0",
                                   "--left-team",
                                   Seat{true}.team(),
                                   "--right-team",
                                   Seat{false}.team(),
                                   "--keepers",
                                   std::to_string(spec.keepers),
                                   "--takers",
                                   std::to_string(spec.takers),
                                   "--lobby-s",
                                   fmt::format("{}", spec.lobby_s),
                                   "--hung-agent-s",
                                   fmt::format("{}", spec.hung_agent_s),
                                   "--results",
                                   result_file(folder)};
    add(words, "--agent-socket", agent_socket(folder));
    if (http_port >= 0) {
        add(words, "--http", std::to_string(http_port));
        add(words, "--beliefs", folder);
        add(words, "--set", fmt::format("first_episode={}", task.index + 1));
    }
    add(words, "--config", spec.server_config);
    add_all(words, spec::parse_settings(spec.settings).server);
    return words;
}

std::vector<std::string> agent_command(const spec::MatchSpec& spec, const Task& task,
                                       const std::string& folder, const Seat& seat, int port,
                                       const std::string& socket) {
    if (is_foreign(spec, seat)) {
        return spec::fill_command(seat.keeper ? spec.keeper_command : spec.taker_command,
                                  {kHost, port, seat.unum, seat.team()});
    }
    std::vector<std::string> words{spec::program_path(spec.agent_program, "k3d-agent"),
                                   "--host",
                                   kHost,
                                   "--port",
                                   std::to_string(port),
                                   "--unum",
                                   std::to_string(seat.unum),
                                   "--team",
                                   seat.team(),
                                   "--role",
                                   seat.keeper ? "keeper" : "taker",
                                   "--seed",
                                   std::to_string(task.seed),
                                   "--keepers",
                                   std::to_string(spec.keepers)};
    add(words, "--socket", socket);
    const spec::Settings settings = spec::parse_settings(spec.settings);
    if (seat.keeper) {
        add(words, "--keeper-policy", spec.keeper_policy);
        add(words, "--telemetry", telemetry_file(folder, seat));
    } else {
        add(words, "--taker", spec.taker);
    }
    if (seat.keeper && spec.http_port >= 0) add(words, "--set", "telemetry_targets=true");
    add(words, "--config", spec.agent_config);
    add_all(words, seat.keeper ? settings.keeper : settings.taker);
    return words;
}

std::vector<AgentProcess> agent_processes(const spec::MatchSpec& spec, const Task& task,
                                          const std::string& folder, int port,
                                          const std::string& socket) {
    std::vector<AgentProcess> out;
    std::size_t shared = kNone;  // place of the process that our agents share
    for (const Seat& seat : seats(spec)) {
        std::vector<std::string> words = agent_command(spec, task, folder, seat, port, socket);
        const bool foreign = is_foreign(spec, seat);
        if (foreign || !spec.one_process) {
            out.push_back({seat.name(), foreign, fmt::format("{}/{}.log", folder, seat.file_stem()),
                           std::move(words)});
        } else if (shared == kNone) {
            shared = out.size();
            out.push_back({"agents", false, folder + "/agents.log", std::move(words)});
        } else {
            std::vector<std::string>& command = out[shared].command;
            command.push_back("--and");
            command.insert(command.end(), words.begin() + 1, words.end());
        }
    }
    return out;
}

}  // namespace k3d::optimizer::episode
