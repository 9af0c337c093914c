// SPDX-License-Identifier: BSD-3-Clause
// Episodes that must all be known before the search can go on: those that the ledger has, those that
// are being played, and what becomes of failed tries.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "optimizer/algorithm/algorithm.h"
#include "optimizer/episode/job.h"
#include "optimizer/hopeless.h"
#include "optimizer/ledger/ledger.h"
#include "optimizer/spec/experiment.h"

namespace k3d::optimizer {

/// Tries of one episode that may give no valid result before it counts as failed.
inline constexpr int kTries = 4;

episode::Phase phase_of(algorithm::Pool pool);

/// From a candidate to the jobs of its episodes.
struct JobMaker {
    const spec::Experiment& experiment;
    std::string run;

    /// Without a payload: the task's settings alone.
    episode::Job job(const std::optional<algorithm::Payload>& payload, episode::Phase phase,
                     const algorithm::Request& request, int episode) const;
};

class Round {
  public:
    explicit Round(const spec::Experiment& experiment) : experiment_(experiment) {}

    /// A further episode, with its row if the ledger has one.
    void add(const episode::Job& job, const ledger::Ledger& ledger);
    void add(const algorithm::Request& request) { requests_.push_back(request); }

    /// Those to be played, in order.
    std::vector<episode::Job> missing() const;
    /// Puts what has come into the ledger, and returns the jobs that are to be tried again. Throws
    /// HopelessRun if a job cannot be played anywhere and there is no result of its kind yet, of
    /// the search or of the test.
    std::vector<episode::Job> take(const std::vector<episode::Outcome>& outcomes,
                                   ledger::Ledger& ledger);

    bool complete() const { return known_ == episodes_.size(); }
    std::size_t known() const { return known_; }
    std::size_t episodes() const { return episodes_.size(); }
    const std::vector<algorithm::Request>& requests() const { return requests_; }
    /// Of a complete request: true if none of its episodes had a valid result.
    bool failed(const algorithm::Request& request) const;
    /// Of a complete request, its failed episodes counted as the worst.
    algorithm::Score score(const algorithm::Request& request) const;
    /// Of the rows that came through take() since the last call.
    std::vector<ledger::Row> take_news();

  private:
    struct Episode {
        episode::Job job;
        std::optional<ledger::Row> row;
    };
    void settle(Episode& episode, const episode::Outcome& outcome, double worth,
                std::vector<ledger::Row>& rows);
    /// True if the episode is to be tried again.
    bool fail(Episode& episode, const episode::Outcome& outcome, const episode::Failure& failure,
              std::vector<ledger::Row>& rows, std::vector<ledger::FailedTry>& failed);
    const ledger::Row& row(const algorithm::Request& request, int episode) const;
    void end_if_hopeless(const episode::Key& key, const episode::Failure& failure,
                         const ledger::Ledger& ledger) const;

    const spec::Experiment& experiment_;
    std::vector<algorithm::Request> requests_;
    std::map<episode::Key, Episode> episodes_;
    std::vector<ledger::Row> news_;
    std::size_t known_ = 0;
};

}  // namespace k3d::optimizer
