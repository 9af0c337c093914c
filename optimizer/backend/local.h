// SPDX-License-Identifier: BSD-3-Clause
// Episodes on this machine: as many at a time as the run has jobs, polled from one thread.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "optimizer/backend/log_folder.h"
#include "optimizer/episode/episode.h"
#include "optimizer/episode/task.h"
#include "optimizer/spec/match_spec.h"

namespace k3d::optimizer::backend {

struct Finished {
    episode::Task task;
    episode::Ending ending;
    double wall_s = 0.0;
    std::string folder;  ///< logs; there to read if the try failed or the user named a folder
};

/// Ending it ends all its processes.
class LocalPool {
  public:
    /// `spec` must outlive it. Throws std::runtime_error if the log folder cannot be made.
    explicit LocalPool(const spec::MatchSpec& spec);
    ~LocalPool();
    LocalPool(const LocalPool&) = delete;
    LocalPool& operator=(const LocalPool&) = delete;

    bool has_room() const;
    std::size_t running() const;
    /// Throws process::ProcessError if the server's program cannot be started.
    void start(const episode::Task& task);
    /// The tries that have ended since the last call.
    std::vector<Finished> poll();
    /// When poll() is due at the latest, unless a child ends before that.
    episode::Clock::time_point next_look() const;
    /// Port of the page, known when its first server is ready, and the same from then on.
    std::optional<int> page_port() const { return page_port_; }

  private:
    const spec::MatchSpec& spec_;
    LogFolder logs_;
    /// Only the first slot's server has the page: a port can be had once.
    std::vector<std::unique_ptr<episode::Episode>> slots_;
    std::optional<int> page_port_;
};

}  // namespace k3d::optimizer::backend
