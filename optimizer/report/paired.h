// SPDX-License-Identifier: BSD-3-Clause
// Tests of one row of episodes against another that met the same seeds or scenarios. All that is
// random here is drawn from fixed streams: the same samples give the same figures.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace k3d::optimizer::report {

/// Of two rows by episode, the samples to compare: what both have, in order. Where episodes play so
/// many fixed scenarios in turn (0: each has its own), they are the means over a scenario's
/// episodes: those that repeat one are no new trials of how players compare on others.
std::pair<std::vector<double>, std::vector<double>> trial_pairs(const std::map<int, double>& a,
                                                                const std::map<int, double>& b,
                                                                int scenarios);

/// `a` less `b`, pair by pair.
struct Paired {
    std::size_t n = 0;           ///< pairs
    double difference = 0.0;     ///< mean of the differences
    double low = 0.0, high = 0.0;  ///< its 95 % interval, Student's t
    /// Two-sided, signs of the differences flipped: in all ways of few pairs, else at random.
    double p_permutation = 1.0;
    double p_wilcoxon = 1.0;     ///< two-sided signed-rank test, normal approximation with ties
    double correlation = 0.0;    ///< of a and b: what pairing has brought
    std::optional<double> ratio;  ///< of the means; none if that of b is not positive
    double ratio_low = 0.0, ratio_high = 0.0;  ///< its 95 % interval, bootstrap over the pairs
};

/// Of samples of the same length; none with fewer than two pairs.
std::optional<Paired> paired(const std::vector<double>& a, const std::vector<double>& b);

/// Holm's correction: what the smallest of several p-values must be multiplied by, the next smaller
/// one, ..., kept in order and at most 1. In the order of `p`.
std::vector<double> holm(const std::vector<double>& p);

}  // namespace k3d::optimizer::report
