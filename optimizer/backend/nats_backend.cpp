// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/backend/nats_backend.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/log/log.h"

namespace k3d::optimizer::backend {

namespace {

constexpr std::chrono::milliseconds kPull{50};
constexpr std::chrono::milliseconds kPublishAgain{500};
constexpr int kBatch = 256;
/// Silence for so many leases, and at least so long, lets us doubt that the queue has our jobs.
constexpr int kSilentLeases = 4;
constexpr std::chrono::seconds kLeastSilence{60};

std::string id_of(const episode::Job& job) {
    return fmt::format("{}/{}/{}", job.run, job.key.text(), job.attempt);
}

}  // namespace

NatsBackend::NatsBackend(const std::string& url, const std::string& run,
                         std::chrono::milliseconds lease)
    : run_(run),
      patience_(std::max<episode::Clock::duration>(kSilentLeases * lease, kLeastSilence)),
      link_(url, "daemon of " + run),
      outcomes_(link_.outcomes(run)) {
    link_.set_lease(lease);
}

NatsBackend::~NatsBackend() {
    // Else workers go on, and the daemon that resumes the run finds what they did; what is not
    // confirmed may be in no ledger, and comes again.
    const bool settled = outstanding_.empty() && unconfirmed_.empty();
    if (settled && link_.ready()) link_.forget(run_);
}

void NatsBackend::submit(const episode::Job& job) {
    outstanding_.insert_or_assign(job.key, job);
    unpublished_.push_back(job.key);
}

void NatsBackend::publish_all_again() {
    unpublished_.clear();
    for (const auto& [key, job] : outstanding_) unpublished_.push_back(key);
    heard_ = episode::Clock::now();
}

void NatsBackend::publish() {
    if (episode::Clock::now() < next_publish_) return;
    while (!unpublished_.empty()) {
        const auto found = outstanding_.find(unpublished_.front());
        if (found != outstanding_.end()) {
            const episode::Job& job = found->second;
            if (!link_.publish(NatsLink::job_subject(run_), id_of(job), episode::to_json(job))) {
                next_publish_ = episode::Clock::now() + kPublishAgain;
                return;
            }
        }
        unpublished_.pop_front();
    }
}

std::vector<episode::Outcome> NatsBackend::poll() {
    ready_ = link_.ready();
    if (!ready_) return {};
    if (link_.losses() != losses_) {
        // A server that was killed may have lost what it had not written yet, or all.
        losses_ = link_.losses();
        publish_all_again();
    }
    if (!outstanding_.empty() && episode::Clock::now() > heard_ + patience_) publish_all_again();
    publish();
    std::vector<episode::Outcome> ended;
    for (NatsMessage& message : outcomes_.pull(kBatch, kPull)) {
        heard_ = episode::Clock::now();
        try {
            ended.push_back(episode::outcome_from_json(message.text()));
            forget(ended.back());
        } catch (const episode::JobError& error) {
            spdlog::warn("an outcome that cannot be read, ignored: {}", error.what());
        }
        unconfirmed_.push_back(std::move(message));
    }
    return ended;
}

void NatsBackend::forget(const episode::Outcome& outcome) {
    const auto found = outstanding_.find(outcome.key);
    if (found == outstanding_.end()) return;
    // A second copy of an earlier try's failure says nothing about the one under way.
    if (outcome.ending || outcome.attempt == found->second.attempt) outstanding_.erase(found);
}

void NatsBackend::confirm() {
    // What is not confirmed, since the server is away, comes again and is known then.
    for (NatsMessage& message : unconfirmed_) {
        if (!message.done()) break;
    }
    unconfirmed_.clear();
}

episode::Clock::time_point NatsBackend::next_look() const {
    // poll() itself waits for what may come, if there is anybody it may come from.
    return episode::Clock::now() + (ready_ ? kPull * 0 : kPublishAgain);
}

std::string NatsBackend::state() const {
    if (!ready_) return "nats-server away";
    return fmt::format("{} at the workers", outstanding_.size());
}

}  // namespace k3d::optimizer::backend
