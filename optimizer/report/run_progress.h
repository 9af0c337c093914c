// SPDX-License-Identifier: BSD-3-Clause
// What the user sees while an experiment runs: on a terminal one line that changes, else a line now
// and then; one line for each generation that is closed.
#pragma once

#include <chrono>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "optimizer/ledger/row.h"

namespace k3d::optimizer::report {

/// How far a run has come.
struct RunView {
    bool test = false;  ///< test episodes: the search is over, or a row of a table plays
    int generation = 0;
    int max_generations = 0;
    std::size_t known = 0;     ///< episodes of the present round
    std::size_t episodes = 0;  ///< the same, all of them
};

class RunProgress {
  public:
    RunProgress(std::ostream& out, bool terminal) : out_(out), terminal_(terminal) {}
    RunProgress(const RunProgress&) = delete;
    RunProgress& operator=(const RunProgress&) = delete;
    ~RunProgress() { wipe(); }

    /// Plain lines, e.g. where the run is.
    void say(const std::string& text);
    /// The same, where a search or a row of a table begins: rates, failures and the end told from
    /// here on are its own.
    void begin(const std::string& text);
    /// `news`: rows that have come in since the last call. Cheap: call it after each wait.
    void show(const RunView& view, const std::vector<ledger::Row>& news,
              const std::string& backend);
    /// A generation is closed; `line` is the algorithm's log of it.
    void closed(const nlohmann::json& line);

    /// Rates and failures of the search or row that plays, as the line tells them.
    std::string rates() const;
    std::string summary() const;  ///< the same since the start
    /// This process' own work as a share of the wall time of its episodes.
    std::string overhead() const;

  private:
    using Clock = std::chrono::steady_clock;
    struct Tally {
        Clock::time_point start = Clock::now();
        std::size_t episodes = 0;
        std::size_t failed = 0;
        double simulated_s = 0.0;

        double wall_s() const;
        std::string rates() const;
    };

    void wipe();
    std::string eta(const RunView& view) const;

    std::ostream& out_;
    bool terminal_;
    bool line_open_ = false;
    Clock::time_point shown_{};
    Tally all_;
    Tally stage_;  ///< of what was begun last: the search, or its test, which is slower
    bool in_test_ = false;
    double wall_s_ = 0.0;  ///< of the episodes, those at the same time added
};

}  // namespace k3d::optimizer::report
