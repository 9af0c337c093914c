// SPDX-License-Identifier: BSD-3-Clause
// A job that is a drill, as a process: k3d-optimizer drill, which owns the server and the agent.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/process/child.h"
#include "optimizer/episode/episode.h"
#include "optimizer/episode/job.h"

namespace k3d::optimizer::drill {

/// The command line that plays the job. In training, validation and test the drill draws, or reads
/// from its tables, other set-ups.
std::vector<std::string> drill_command(const episode::Job& job, const std::string& folder);

/// Exit code of a drill that ended because server or agent could not be started, which is this
/// machine's fault and says nothing of the job.
inline constexpr int kExitCannotStart = 3;

class DrillProcess {
  public:
    /// Starts it; all files go to `folder`, which exists. Throws process::StartError.
    DrillProcess(const episode::Job& job, const std::string& folder);

    /// Does what is due, without waiting. The ending comes once, and then no process is left.
    std::optional<episode::Ending> poll();
    /// When poll() is due at the latest, unless a child ends before that.
    episode::Clock::time_point next_look() const;
    episode::Clock::time_point started() const { return started_; }

  private:
    episode::Job job_;
    std::string folder_;
    episode::Clock::time_point started_;
    process::Child child_;
};

}  // namespace k3d::optimizer::drill
