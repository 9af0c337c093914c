// SPDX-License-Identifier: BSD-3-Clause
// A table of test episodes: rows that met the same seeds, each figure with its mean, spread and
// interval, and beside it how far it lies from the reference row, by seed; of a drill that repeats
// fixed scenarios by scenario, each the mean of its episodes. As text, CSV and HTML.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/episode/result.h"
#include "optimizer/ledger/row.h"
#include "optimizer/report/paired.h"
#include "optimizer/report/statistics.h"
#include "optimizer/report/survival.h"
#include "optimizer/spec/reproduction.h"

namespace k3d::optimizer::report {

struct ComparedRow {
    spec::RowSpec spec;
    std::string origin;              ///< who plays, e.g. which candidate of which run
    std::vector<ledger::Row> rows;   ///< in the order of episodes; fewer if the table is unfinished
    std::string version = {};        ///< of the code that played them
    /// Those of `rows`, in their order; none of an episode without a valid one. compare() reads
    /// them.
    std::vector<std::optional<k3d::episode::Result>> results = {};
};

/// One row in one figure.
struct ComparedLine {
    std::string key;
    std::string label;  ///< at its end "(median run)" of three or more, or how much of it is played
    Statistics s;
    std::optional<Paired> against;  ///< the reference row; none of that row itself
    double p_holm = 1.0;            ///< of the permutation test, over the lines of this figure
};

struct ComparedFigure {
    std::string name;      ///< "hold_time_s"
    std::string title;     ///< "Hold time, s"
    std::vector<ComparedLine> lines;
};

/// One row in how long possession lasts, with what the time limit cut off.
struct SurvivalLine {
    std::string key;
    std::string label;
    Survival s;
    std::optional<SurvivalTest> against;  ///< as above
};

/// How the episodes of a row went apart from its figures.
struct Circumstances {
    std::size_t episodes = 0;
    int failed = 0;        ///< no valid result in all tries; in no mean
    int truncated = 0;     ///< at the time limit; in the means
    std::optional<double> taker_speed;   ///< m/s, mean over takers and episodes
    std::optional<double> keeper_speed;
    std::optional<double> falls_per_minute;  ///< and player
    std::string endings;
};

/// A table and all that is said of it.
struct Comparison {
    spec::TableSpec table;
    std::vector<ComparedRow> rows;
    std::vector<spec::PaperRow> paper;
    std::vector<ComparedFigure> figures;
    /// A line per row of keepaway; empty for drills, whose time is not one that somebody keeps the
    /// ball.
    std::vector<SurvivalLine> survival;
    std::vector<Circumstances> circumstances;  ///< of each row
};

/// Reads every result and computes every figure, which takes a while: once, for all that is written
/// of the table. Throws k3d::episode::ResultError for a result that cannot be read.
Comparison compare(spec::TableSpec table, std::vector<ComparedRow> rows,
                   std::vector<spec::PaperRow> paper = {});
/// Empty, or that rows of this table were played by different versions of the code, and which.
std::string warning(const Comparison& comparison);

std::string comparison_text(const Comparison& comparison);
std::string comparison_html(const Comparison& comparison);
/// A line per row and figure; the head is comparison_csv_head().
std::string comparison_csv(const Comparison& comparison);
std::string comparison_csv_head();
/// A line per row and test episode with the table's figures, those it has: whoever wants other statistics
/// than ours, or to compare with rows of their own on these seeds, needs no replay.
std::string episodes_csv(const Comparison& comparison);

}  // namespace k3d::optimizer::report
