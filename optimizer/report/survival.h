// SPDX-License-Identifier: BSD-3-Clause
// How long possession lasts where some episodes were cut off at the time limit: such an episode
// tells that it would have lasted longer, not how long, so that its time lowers a mean. What stands
// here counts it for as long as it was watched. All that is random is drawn from fixed streams: the
// same samples give the same figures.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace k3d::optimizer::report {

struct Lifetime {
    double s = 0.0;     ///< watched for
    bool ended = true;  ///< false: cut off
};

struct Survival {
    std::size_t ended = 0;
    std::size_t cut = 0;
    /// Time watched over the episodes that ended: the mean of all, had they gone on to end at the
    /// rate seen. None if none ended.
    std::optional<double> s_per_end;
};

/// `a` against `b`.
struct SurvivalTest {
    std::size_t pairs = 0;
    std::optional<double> ratio;  ///< of the two s_per_end; none if one of them has none
    double ratio_low = 0.0, ratio_high = 0.0;  ///< its 95 % interval, bootstrap over the pairs
    double p_log_rank = 1.0;  ///< two-sided log-rank test (Mantel 1966), chi-square with one degree
};

Survival survival(const std::vector<Lifetime>& sample);

/// Of samples of the same length, pair by pair of the same seed; none with fewer than two pairs.
std::optional<SurvivalTest> survival_test(const std::vector<Lifetime>& a,
                                          const std::vector<Lifetime>& b);

}  // namespace k3d::optimizer::report
