// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/episode/episode.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "common/config/command_line.h"
#include "optimizer/episode/collect.h"

namespace k3d::optimizer::episode {

namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr milliseconds kReadyPoll{5};
/// A server that has lost an agent ends the episode by itself; in the lobby it would wait on.
constexpr seconds kServerPatience{5};
/// Our agents end with the server's connection and write their last telemetry then; foreign ones
/// may not notice, and nothing is wanted of them.
constexpr seconds kAgentPatience{20};
constexpr seconds kForeignPatience{1};

Clock::duration in_seconds(double value) {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(value));
}

process::Child start_server(const spec::MatchSpec& spec, const Task& task,
                            const std::string& folder, int http_port) {
    return process::Child(
        {server_command(spec, task, folder, http_port), folder + "/server.log", true, spec.pace == "fast"});
}

}  // namespace

Episode::Episode(const spec::MatchSpec& spec, const Task& task, std::string folder, int http_port)
    : spec_(spec),
      task_(task),
      folder_(std::move(folder)),
      started_(Clock::now()),
      server_(start_server(spec_, task_, folder_, http_port)) {}

std::optional<Ending> Episode::poll() {
    std::optional<Ending> ending;
    if (phase_ == Phase::Starting) ending = start_agents_when_ready();
    if (!ending && phase_ == Phase::Playing) ending = watch();
    if (!ending && phase_ == Phase::Leaving) ending = wait_for_agents_to_leave();
    if (!ending && Clock::now() >= started_ + in_seconds(spec_.deadline_s)) {
        ending = fail(fmt::format("no end after {} s", spec_.deadline_s));
    }
    if (ending) {
        agents_.clear();
        server_.kill();
    }
    return ending;
}

std::optional<Ending> Episode::start_agents_when_ready() {
    const auto exit = server_.poll();
    if (const auto ready = server_.poll_ready()) {
        page_port_ = process::port_in(*ready, "http");
        const auto port = process::port_in(*ready, "agent");
        if (!port) return fail("the server's ready line names no agent port", 1);
        try {
            start_agents(*port);
        } catch (const process::StartError& error) {
            return tl::unexpected(Failure{error.what(), std::nullopt, 1, true});
        }
        phase_ = Phase::Playing;
    } else if (exit) {
        // It has not met an agent yet: what stopped it was its flags, files or ports.
        return fail(describe_end("server", *exit, folder_ + "/server.log"),
                    exit->signalled ? std::nullopt : std::optional(std::max(exit->code, 1)));
    } else if (Clock::now() >= started_ + in_seconds(spec_.lobby_s)) {
        return fail(fmt::format("the server is not ready after {} s", spec_.lobby_s));
    }
    return std::nullopt;
}

void Episode::start_agents(int port) {
    std::string socket = agent_socket(folder_);
    std::error_code ignored;
    if (!std::filesystem::exists(socket, ignored)) socket.clear();
    const bool batch = spec_.pace == "fast";
    for (AgentProcess& start : agent_processes(spec_, task_, folder_, port, socket)) {
        process::Child child({std::move(start.command), start.log_file, false, batch});
        agents_.push_back({std::move(start.name), start.foreign, start.log_file, std::move(child)});
    }
}

std::optional<Ending> Episode::watch() {
    if (const auto exit = server_.poll()) {
        server_exit_ = exit;
        server_ended_ = Clock::now();
        phase_ = Phase::Leaving;
        return std::nullopt;
    }
    for (Agent& agent : agents_) {
        const auto exit = agent.child.poll();
        if (!exit) continue;
        const std::string end = describe_end(agent.name, *exit, agent.log_file);
        if (!agent.foreign && exit->code == config::kExitUsage) {
            return fail(end, config::kExitUsage);
        }
        if (deserter_.empty()) deserted_ = Clock::now();
        // Who ended in disorder is the cause, and the others may only have followed.
        if (deserter_.empty() || (deserter_code_ == 0 && exit->code != 0)) {
            deserter_ = end;
            deserter_code_ = exit->code;
        }
    }
    if (!deserter_.empty() && Clock::now() >= deserted_ + kServerPatience) return fail(deserter_);
    return std::nullopt;
}

Clock::time_point Episode::patience_with(const Agent& agent) const {
    return server_ended_ + (agent.foreign ? kForeignPatience : kAgentPatience);
}

std::optional<Ending> Episode::wait_for_agents_to_leave() {
    const bool in_order = server_exit_->code == 0;  // else nothing is wanted of the agents
    for (Agent& agent : agents_) {
        if (!in_order || agent.child.poll()) continue;
        if (Clock::now() < patience_with(agent)) return std::nullopt;
        // Its telemetry may lack an end; only where none is read is that no matter.
        if (!agent.foreign) return fail(agent.name + " did not end with the server");
    }
    Ending ending = collect(spec_, task_, folder_, *server_exit_);
    if (!ending && server_exit_->code == kServerLostAnAgent && deserter_code_ != 0) {
        ending.error().reason += "; first to go: " + deserter_;
    }
    return ending;
}

Clock::time_point Episode::next_look() const {
    Clock::time_point next = started_ + in_seconds(spec_.deadline_s);
    if (phase_ == Phase::Starting) return std::min(next, Clock::now() + kReadyPoll);
    if (phase_ == Phase::Playing && !deserter_.empty()) {
        next = std::min(next, deserted_ + kServerPatience);
    }
    if (phase_ == Phase::Leaving) {
        for (const Agent& agent : agents_) {
            if (patience_with(agent) > Clock::now()) next = std::min(next, patience_with(agent));
        }
    }
    return next;
}

Ending Episode::fail(std::string reason, std::optional<int> hopeless) {
    return tl::unexpected(Failure{std::move(reason), std::nullopt, hopeless});
}

}  // namespace k3d::optimizer::episode
