// SPDX-License-Identifier: BSD-3-Clause
// The course of a run as numbers to be plotted, from its ledger alone.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "optimizer/ledger/ledger.h"
#include "optimizer/report/statistics.h"

namespace k3d::optimizer::report {

/// Means of the candidates of one generation over their training episodes.
struct GenerationFigures {
    int generation = 0;
    double best = 0.0;
    double median = 0.0;
    Statistics all;  ///< mean, sd and se over candidates
};

/// A finalist or champion on validation seeds, and after which generation.
struct ValidatedFigures {
    int generation = 0;
    double mean = 0.0;
    double se = 0.0;
};

/// One parameter over the generations.
struct Trace {
    std::string name;
    std::vector<double> best;      ///< of the candidate with the best mean
    std::vector<double> low, high;  ///< 10 % and 90 % of the candidates
};

struct Curves {
    std::vector<GenerationFigures> fitness;
    std::vector<ValidatedFigures> champion;  ///< as it stood after each generation
    std::map<std::string, std::vector<double>> logged;  ///< plain numbers of the log, by name
    std::map<int, std::vector<double>> species;         ///< members by species, a value a generation
    std::vector<Trace> parameters;
};

/// `names`: of the values of a candidate; empty if candidates are networks.
Curves curves_of(const ledger::Ledger& ledger, const std::vector<std::string>& names);

/// Differences champion less untuned on the same test seeds, in the pairs of trial_pairs().
Statistics paired_difference(const std::vector<ledger::Row>& rows, int scenarios);

}  // namespace k3d::optimizer::report
