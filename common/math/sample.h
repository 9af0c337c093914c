// SPDX-License-Identifier: BSD-3-Clause
// What several stages say of a sample of numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "common/log/log.h"

namespace k3d {

/// The sample must not be empty, here and below.
inline double mean_of(const std::vector<double>& sample) {
    K3D_ASSERT(!sample.empty());
    return std::accumulate(sample.begin(), sample.end(), 0.0) / static_cast<double>(sample.size());
}

/// Sum of the squared distances from the mean. A second pass: the sum of squares less the square of
/// the sum would cancel.
inline double squares_about(const std::vector<double>& sample, double mean) {
    double squares = 0.0;
    for (const double value : sample) squares += (value - mean) * (value - mean);
    return squares;
}

/// Value below which a share of the sample lies, between neighbours on a straight line.
inline double quantile(std::vector<double> sample, double share) {
    K3D_ASSERT(!sample.empty());
    std::sort(sample.begin(), sample.end());
    const double place = share * static_cast<double>(sample.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sample.size() - 1);
    return sample[below] + (place - static_cast<double>(below)) * (sample[above] - sample[below]);
}

}  // namespace k3d
