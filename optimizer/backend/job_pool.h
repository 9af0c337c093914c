// SPDX-License-Identifier: BSD-3-Clause
// Jobs on this machine: some at a time, each a tree of processes of its own, polled from one thread.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "optimizer/drill/drill_process.h"
#include "optimizer/episode/episode.h"
#include "optimizer/episode/job.h"
#include "optimizer/spec/match_spec.h"

namespace k3d::optimizer::backend {

/// Ending it ends all its processes.
class JobPool {
  public:
    /// Logs go to a folder per try in `log_folder` (empty: a temporary one); those of failed tries
    /// stay, of the last kKeptLogs. Throws std::runtime_error if the folder cannot be made.
    JobPool(int slots, const std::string& log_folder);
    ~JobPool();
    JobPool(const JobPool&) = delete;
    JobPool& operator=(const JobPool&) = delete;

    std::size_t room() const { return slots_ - running_.size(); }
    std::size_t running() const { return running_.size(); }
    /// Throws process::ProcessError or std::runtime_error if it cannot even be started: that is this
    /// machine's fault, and no try of the job.
    void start(const episode::Job& job);
    /// The tries that have ended since the last call. One that failed while the log folder's disk
    /// was full, or for which a further program could not be started, is none either: after the
    /// results that came with it, std::runtime_error.
    std::vector<episode::Outcome> poll();
    /// The same, each with its run.
    std::vector<std::pair<std::string, episode::Outcome>> poll_with_runs();
    /// When poll() is due at the latest, unless a child ends before that.
    episode::Clock::time_point next_look() const;

    /// How far a running job has come: grows as its simulated time does.
    struct Progress {
        std::string run;
        episode::Key key;
        int attempt;
        std::uintmax_t done;
    };
    std::vector<Progress> progress() const;

  private:
    static constexpr std::size_t kKeptLogs = 50;

    struct Running {
        episode::Job job;
        std::string folder;
        spec::MatchSpec match;
        std::variant<std::unique_ptr<episode::Episode>, std::unique_ptr<drill::DrillProcess>>
            episode;  ///< a match or a drill
        episode::Clock::time_point started() const;
    };

    episode::Outcome outcome(const Running& running, episode::Ending ending) const;
    void end_logs(const std::string& folder, bool failed);

    std::size_t slots_;
    std::string folder_;
    bool temporary_;
    std::string worker_;
    std::vector<std::unique_ptr<Running>> running_;
    std::deque<std::string> kept_;
    std::string fault_;  ///< this machine's; told by the next poll() that has nothing else to tell
};

}  // namespace k3d::optimizer::backend
