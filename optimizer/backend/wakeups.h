// SPDX-License-Identifier: BSD-3-Clause
// What the daemon sleeps until: the end of a child, the user's wish to stop, a point in time.
#pragma once

#include <signal.h>

#include <chrono>

namespace k3d::optimizer::backend {

/// While it lives, SIGCHLD, SIGINT, SIGTERM and SIGHUP are blocked: none is lost between a look at
/// the children and the next wait, and none interrupts anything else. For programs without threads.
class Wakeups {
  public:
    Wakeups();
    ~Wakeups();
    Wakeups(const Wakeups&) = delete;
    Wakeups& operator=(const Wakeups&) = delete;

    /// Returns when a child has ended, at `deadline`, or at once if the user wants to stop.
    void wait(std::chrono::steady_clock::time_point deadline);

    bool stop_wanted() const { return stop_wanted_; }

  private:
    sigset_t awaited_;
    sigset_t before_;
    bool stop_wanted_ = false;
};

}  // namespace k3d::optimizer::backend
