// SPDX-License-Identifier: BSD-3-Clause
// Noisy fitness: mean, standard error and number of episodes, ranked.
#pragma once

#include <cstddef>
#include <vector>

#include "optimizer/algorithm/state_json.h"

namespace k3d::optimizer::algorithm {

/// Fitness of one candidate over its episodes of one pool.
struct Score {
    double mean = 0.0;  ///< finite; larger is better
    double se = 0.0;    ///< standard error of the mean, >= 0; 0 if there is no noise or n is 1
    int n = 0;          ///< episodes in it, >= 1
    bool operator==(const Score&) const = default;
};

/// Mean and standard error (of n - 1) of single fitness values; at least one.
Score score_of(const std::vector<double>& values);

/// What a generation learned of one candidate.
struct Outcome {
    bool failed = false;  ///< no result could be had
    Score score;
    bool operator==(const Outcome&) const = default;
};

/// Indices from the best to the worst; failed ones last, equals in order of birth.
std::vector<std::size_t> ranking(const std::vector<Outcome>& outcomes);

/// Share of the spread of fitness over the candidates that is not noise, 0 to 1:
/// 1 - mean squared standard error / variance of the means. 1 if nobody has a standard error.
double reliability(const std::vector<Outcome>& outcomes);

nlohmann::json save(const Score& score);
Score read_score(const Reader& reader);

}  // namespace k3d::optimizer::algorithm
