// SPDX-License-Identifier: BSD-3-Clause
// A worker: takes jobs from nats-server, plays them on this machine, gives the outcomes back. Workers
// come and go at any time; what one leaves undone another one gets.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "optimizer/backend/job_pool.h"
#include "optimizer/backend/nats_link.h"
#include "optimizer/backend/wakeups.h"

namespace k3d::optimizer::backend {

struct WorkerOptions {
    std::string url = "nats://127.0.0.1:4222";
    int jobs = 1;
    std::string log_folder;
    double idle_s = 0.0;  ///< ends after so long without work; 0: never
};

class Worker {
  public:
    /// Throws NatsError if the server cannot be reached.
    explicit Worker(const WorkerOptions& options);
    /// What it was at is given back: others get it at once.
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// Works until the user wants it to stop, or for too long nothing was to be done. Throws
    /// std::runtime_error if this machine can play nothing: its disk is full, or a program cannot
    /// be started here. Others may be able to.
    void work(Wakeups& wakeups);

  private:
    /// Run, episode and attempt. The daemon may give out an episode's next attempt, after another
    /// worker's failure, while an earlier one is still under way here: each has an answer of its own.
    using Try = std::tuple<std::string, episode::Key, int>;
    struct Held {
        NatsMessage message;
        std::string run;
        std::uintmax_t progress = 0;
    };
    struct Finished {
        NatsMessage message;
        std::string run;
        episode::Outcome outcome;
    };

    void take();
    void accept(NatsMessage message);
    void collect();
    void deliver();
    void keep_leases();

    WorkerOptions options_;
    NatsLink link_;
    NatsSource jobs_;
    JobPool pool_;
    std::map<Try, Held> held_;
    std::vector<Finished> finished_;
    episode::Clock::time_point leases_kept_ = episode::Clock::now();
    episode::Clock::time_point busy_ = episode::Clock::now();
};

}  // namespace k3d::optimizer::backend
