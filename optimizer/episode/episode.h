// SPDX-License-Identifier: BSD-3-Clause
// One try of one episode as processes: a server, then the agents, each of them new and owned.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "common/process/child.h"
#include "optimizer/episode/commands.h"
#include "optimizer/episode/task.h"
#include "optimizer/spec/match_spec.h"

namespace k3d::optimizer::episode {

using Clock = std::chrono::steady_clock;

class Episode {
  public:
    /// Starts the server; all files go to `folder`, which exists. `http_port` -1: no page. Throws
    /// process::StartError if the server's program cannot be started.
    Episode(const spec::MatchSpec& spec, const Task& task, std::string folder, int http_port);

    /// Does what is due, without waiting. The ending comes once, and then no process is left.
    std::optional<Ending> poll();

    /// When poll() is due at the latest, unless a child ends before that.
    Clock::time_point next_look() const;

    std::optional<int> page_port() const { return page_port_; }  ///< once the server is ready
    const Task& task() const { return task_; }
    const std::string& folder() const { return folder_; }
    Clock::time_point started() const { return started_; }

  private:
    /// The server opens its ports; the game; the server has ended and the agents notice.
    enum class Phase { Starting, Playing, Leaving };

    struct Agent {
        std::string name;
        bool foreign;
        std::string log_file;
        process::Child child;
    };

    std::optional<Ending> start_agents_when_ready();
    std::optional<Ending> watch();
    std::optional<Ending> wait_for_agents_to_leave();
    void start_agents(int port);
    Clock::time_point patience_with(const Agent& agent) const;
    Ending fail(std::string reason, std::optional<int> hopeless = {});

    const spec::MatchSpec& spec_;
    Task task_;
    std::string folder_;
    Clock::time_point started_;
    Phase phase_ = Phase::Starting;
    process::Child server_;
    std::optional<process::Exit> server_exit_;
    Clock::time_point server_ended_;
    std::vector<Agent> agents_;
    std::string deserter_;  ///< how an agent ended while the server ran
    int deserter_code_ = 0;
    Clock::time_point deserted_;
    std::optional<int> page_port_;
};

}  // namespace k3d::optimizer::episode
