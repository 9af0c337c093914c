// SPDX-License-Identifier: BSD-3-Clause
// The report of a run: one HTML file that needs nothing beside it, and tables as CSV.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "optimizer/algorithm/algorithm.h"
#include "optimizer/ledger/ledger.h"
#include "optimizer/spec/experiment.h"

namespace k3d::optimizer::report {

struct RunFacts {
    const ledger::Ledger& ledger;
    const spec::Experiment& experiment;
    std::optional<algorithm::Champion> champion;
    std::optional<std::string> ended;
};

/// Writes report.html, episodes.csv, generations.csv and champion.toml or .json into `folder`,
/// which is made. Throws std::runtime_error naming a file that cannot be written. Returns the path
/// of report.html.
std::string write_report(const RunFacts& run, const std::string& folder);

/// Style sheet of this page and others like it.
std::string_view page_style();

/// The page alone.
std::string report_html(const RunFacts& run);

/// Who a champion is and of which run.
std::string origin_of(const algorithm::Champion& champion, const ledger::Facts& facts);
/// What stands at a champion's head: its origin, the command that made it, and what that cost.
std::string provenance_of(const algorithm::Champion& champion, const spec::Experiment& experiment,
                          const ledger::Ledger& ledger);

/// From such a head: the command that made it; none if it is of no run of this search.
std::optional<std::string> command_in(const std::string& provenance, const std::string& search);

/// Names of the values of a candidate; empty if candidates are networks that differ in shape.
std::vector<std::string> value_names(const spec::Experiment& experiment);

}  // namespace k3d::optimizer::report
