// SPDX-License-Identifier: BSD-3-Clause
// A run of an experiment: its folder, its ledger, and the algorithm as far as it has come.
//
//     RUN/ledger.sqlite   the truth       RUN/lock     held while a daemon is at work
//     RUN/logs/           of failed tries RUN/report/  report.html and its tables
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optimizer/algorithm/algorithm.h"
#include "optimizer/ledger/ledger.h"
#include "optimizer/ledger/lock.h"
#include "optimizer/report/run_progress.h"
#include "optimizer/round.h"
#include "optimizer/spec/experiment.h"

namespace k3d::optimizer {

class Run {
  public:
    /// A new run of the experiment in `file`, in `folder` (empty: runs/NAME). Throws ConfigError for
    /// the experiment, LedgerError if the folder has a run.
    static Run begin(const std::string& file, const spec::Overrides& overrides,
                     const std::string& folder, const std::string& command);
    /// Throws what begin() would for the experiment, and begins nothing.
    static void check(const std::string& file, const spec::Overrides& overrides);
    /// Throws LedgerError if the run in `folder` is of another experiment than begin() would make of
    /// these: other text, network or overrides.
    static void require(const std::string& folder, const std::string& file,
                        const spec::Overrides& overrides);
    /// Goes on where the run in `folder` was left. Throws LedgerError, AlgorithmError; also if this
    /// is another code version, whose results would not be those that the run began with.
    static Run resume(const std::string& folder);

    /// What is to be played next: a round of the search, then the champion's test; none at the end.
    std::optional<Round> next_round();
    /// `round` is complete: tells the algorithm and saves its state. Returns a line of its log for
    /// each generation that this has closed.
    std::vector<nlohmann::json> close(const Round& round);
    report::RunView view(const Round& round) const;

    const std::string& folder() const { return folder_; }
    std::string name() const { return experiment_.name; }
    const std::string& id() const { return id_; }
    const spec::Experiment& experiment() const { return experiment_; }
    const algorithm::Algorithm& algorithm() const { return *algorithm_; }
    ledger::Ledger& ledger() { return ledger_; }
    /// Why the search is over; none while it goes on.
    std::optional<std::string> ended() const { return algorithm_->finished(); }

  private:
    Run(std::string folder, std::unique_ptr<ledger::Lock> lock, ledger::Ledger ledger);
    bool hours_are_used_up() const;
    Round search_round();
    Round test_round() const;

    std::string folder_;
    std::unique_ptr<ledger::Lock> lock_;
    ledger::Ledger ledger_;
    spec::Experiment experiment_;
    std::string id_;  ///< of this run among all on a queue
    std::optional<algorithm::Algorithm> algorithm_;
    int rounds_ = 0;
};

/// The experiment as the ledger of a run has it.
spec::Experiment experiment_of(const ledger::Facts& facts);
/// "RUN/ledger.sqlite".
std::string ledger_file(const std::string& folder);

}  // namespace k3d::optimizer
