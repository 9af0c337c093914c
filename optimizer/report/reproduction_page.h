// SPDX-License-Identifier: BSD-3-Clause
// The report of `k3d-optimizer reproduce`: what was searched for how long, learning curves, and the
// tables of test episodes.
#pragma once

#include <string>
#include <vector>

#include "optimizer/ledger/ledger.h"
#include "optimizer/report/comparison.h"
#include "optimizer/report/curves.h"
#include "optimizer/spec/reproduction.h"

namespace k3d::optimizer::report {

struct SearchReport {
    spec::Search search;
    int run = 1;
    std::string algorithm;
    std::string measure;   ///< what it maximised
    std::string champion;  ///< who it is, and its validation score
    std::string version;
    int generations = 0;
    bool finished = false;
    ledger::Ledger::Totals totals;
    Curves curves;
    std::string fault = {};  ///< why its run cannot be read; then the rest is empty
};

struct Reproduction {
    std::string budget;
    std::string description;  ///< of the budget
    std::string version;
    std::vector<SearchReport> searches;
    std::vector<Comparison> tables;
};

std::string reproduction_text(const Reproduction& reproduction);
std::string reproduction_html(const Reproduction& reproduction);
std::string reproduction_csv(const Reproduction& reproduction);
/// A line per run of a search: episodes, simulated hours, generations.
std::string searches_csv(const Reproduction& reproduction);

/// report.html, tables.txt, tables.csv, searches.csv and episodes/TABLE.csv in `folder`. Throws std::runtime_error naming
/// a file that cannot be written. Returns the path of report.html.
std::string write_reproduction(const Reproduction& reproduction, const std::string& folder);

}  // namespace k3d::optimizer::report
