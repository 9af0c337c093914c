// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/backend/worker.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/log/log.h"

namespace k3d::optimizer::backend {

namespace {

constexpr std::chrono::milliseconds kPullIdle{500};
constexpr std::chrono::milliseconds kPullBusy{20};
constexpr std::chrono::milliseconds kLongestWait{100};
constexpr std::chrono::milliseconds kAwayWait{500};
constexpr std::chrono::milliseconds kKeepLeases{400};
/// A job that so many workers took and never finished is likely to be what ended them.
constexpr std::uint64_t kMaxDeliveries = 10;

std::string id_of(const std::string& run, const episode::Outcome& outcome) {
    return fmt::format("{}/{}/{}/{}", run, outcome.key.text(), outcome.attempt,
                       outcome.ending ? "result" : "failure");
}

}  // namespace

Worker::Worker(const WorkerOptions& options)
    : options_(options),
      link_(options.url, "worker"),
      jobs_(link_.jobs()),
      pool_(options.jobs, options.log_folder) {}

Worker::~Worker() {
    for (auto& [which, held] : held_) held.message.again();
}

void Worker::work(Wakeups& wakeups) {
    const auto idle = std::chrono::duration<double>(options_.idle_s);
    while (!wakeups.stop_wanted()) {
        const bool ready = link_.ready();
        if (ready) take();
        collect();
        deliver();
        keep_leases();
        const auto now = episode::Clock::now();
        if (pool_.running() > 0 || !finished_.empty()) busy_ = now;
        if (options_.idle_s > 0.0 && now - busy_ > idle) break;
        auto next = std::min(pool_.next_look(), now + kLongestWait);
        if (!ready) next = now + kAwayWait;
        if (pool_.running() == 0 && ready) next = now;  // take() waits
        wakeups.wait(next);
    }
}

void Worker::take() {
    const auto room = static_cast<int>(pool_.room());
    if (room == 0) return;
    for (NatsMessage& message : jobs_.pull(room, pool_.running() > 0 ? kPullBusy : kPullIdle)) {
        accept(std::move(message));
    }
}

void Worker::accept(NatsMessage message) {
    episode::Job job;
    try {
        job = episode::job_from_json(message.text());
    } catch (const episode::JobError& error) {
        spdlog::error("a job that cannot be read, dropped: {}", error.what());
        message.done();
        return;
    }
    const Try which{job.run, job.key, job.attempt};
    if (const auto found = held_.find(which); found != held_.end()) {
        // Our own lease of it ran out, and it came back to us: go on with the try under way.
        found->second.message = std::move(message);
        return;
    }
    if (message.deliveries() > kMaxDeliveries) {
        episode::Outcome outcome{job.key, job.seed, job.attempt, episode::fingerprint(job), {}, 0.0,
                                 "queue"};
        outcome.ending = tl::unexpected(episode::Failure{
            fmt::format("{} workers took it and did not finish", message.deliveries() - 1),
            std::nullopt, std::nullopt});
        finished_.push_back({std::move(message), job.run, std::move(outcome)});
        return;
    }
    held_.emplace(which, Held{std::move(message), job.run});
    pool_.start(job);
}

void Worker::collect() {
    for (const auto& [run, outcome] : pool_.poll_with_runs()) {
        const auto found = held_.find({run, outcome.key, outcome.attempt});
        K3D_ASSERT(found != held_.end());
        finished_.push_back({std::move(found->second.message), run, outcome});
        held_.erase(found);
    }
}

void Worker::deliver() {
    bool stored = true;
    std::erase_if(finished_, [&](Finished& f) {
        if (!stored) return false;  // nor would this one be
        // The outcome first: if we die between the two, the job is played again and comes out the
        // same; the other way round it would be lost.
        const std::string text = episode::to_json(f.run, f.outcome);
        stored = link_.publish(NatsLink::outcome_subject(f.run), id_of(f.run, f.outcome), text);
        if (stored) f.message.done();
        return stored;
    });
}

void Worker::keep_leases() {
    if (episode::Clock::now() < leases_kept_ + kKeepLeases) return;
    leases_kept_ = episode::Clock::now();
    for (const JobPool::Progress& progress : pool_.progress()) {
        const auto found = held_.find({progress.run, progress.key, progress.attempt});
        if (found == held_.end() || progress.done <= found->second.progress) continue;
        found->second.progress = progress.done;
        found->second.message.alive();  // simulated time has passed
    }
    for (Finished& f : finished_) f.message.alive();
}

}  // namespace k3d::optimizer::backend
