// SPDX-License-Identifier: BSD-3-Clause
// How the programs of an episode are started: their command lines, and the names of their files.
#pragma once

#include <string>
#include <vector>

#include "optimizer/episode/task.h"
#include "optimizer/spec/match_spec.h"

namespace k3d::optimizer::episode {

struct Seat {
    bool keeper = true;
    int unum = 1;

    std::string name() const;       ///< "keeper 2"
    std::string file_stem() const;  ///< "keeper-2"
    std::string team() const;       ///< "Keepers" or "Takers"
};

/// Keepers first, by number.
std::vector<Seat> seats(const spec::MatchSpec& spec);
/// True if the seat is taken by a program other than k3d-agent.
bool is_foreign(const spec::MatchSpec& spec, const Seat& seat);

std::string result_file(const std::string& folder);
std::string telemetry_file(const std::string& folder, const Seat& seat);

/// Where the server may listen for our agents besides its port; empty if the name would be too long.
std::string agent_socket(const std::string& folder);

/// A process beside the server: one agent, or all of ours (MatchSpec::one_process).
struct AgentProcess {
    std::string name;  ///< "keeper 2", or "agents"
    bool foreign = false;
    std::string log_file;
    std::vector<std::string> command;
};

/// `http_port` -1: no page.
std::vector<std::string> server_command(const spec::MatchSpec& spec, const Task& task,
                                        const std::string& folder, int http_port);
/// `socket`: of agent_socket(), if the server listens there; foreign programs take the port.
std::vector<std::string> agent_command(const spec::MatchSpec& spec, const Task& task,
                                       const std::string& folder, const Seat& seat, int port,
                                       const std::string& socket = {});
/// Of all seats, in their order.
std::vector<AgentProcess> agent_processes(const spec::MatchSpec& spec, const Task& task,
                                          const std::string& folder, int port,
                                          const std::string& socket);

}  // namespace k3d::optimizer::episode
