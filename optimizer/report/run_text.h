// SPDX-License-Identifier: BSD-3-Clause
// A run as text: its rows as CSV, its course and champion for the terminal and for the agent.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optimizer/algorithm/algorithm.h"
#include "optimizer/ledger/ledger.h"
#include "optimizer/report/statistics.h"
#include "optimizer/spec/experiment.h"

namespace k3d::optimizer::report {

/// A text as a cell of CSV that may hold commas and quotes.
std::string csv_quoted(const std::string& text);

/// One line per episode, in the order of keys. Canonical: only what follows from experiment and
/// seed, so that runs on any number of workers, with any faults, give the same bytes.
std::string csv(const std::vector<ledger::Row>& rows, bool canonical);

/// A line per generation with what the algorithm logged; columns in the order of first appearance.
std::string generations_csv(const std::vector<nlohmann::json>& log);

/// Of the rows of one phase and, if given, one candidate.
Statistics fitness_of(const std::vector<ledger::Row>& rows, episode::Phase phase,
                      std::optional<std::uint64_t> candidate = {});

/// "34.21 (n 100, sd 12.3, se 1.23, 95 % 31.8 to 36.6)".
std::string describe(const Statistics& s);
/// Half the width of the mean's 95 % confidence interval: Student's t times se; none below two.
std::optional<double> half_width_95(const Statistics& s);

/// What `show` prints.
std::string course(const ledger::Ledger& ledger, const std::optional<std::string>& ended);

/// The champion as k3d-agent takes it: TOML for --config, or a network file. The comment of the
/// TOML, or the network's description, says where it comes from.
std::string champion_file(const spec::Experiment& experiment,
                          const algorithm::Champion& champion, const std::string& origin);

}  // namespace k3d::optimizer::report
