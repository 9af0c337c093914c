// SPDX-License-Identifier: BSD-3-Clause
// Mean, standard deviation and standard error of a sample.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "common/math/sample.h"

namespace k3d::optimizer::report {

struct Statistics {
    std::size_t n = 0;
    std::optional<double> mean;  ///< none for an empty sample
    std::optional<double> sd;    ///< of the population, estimated with n - 1; none below two values
    std::optional<double> se;    ///< of the mean: sd / sqrt(n)
};

inline Statistics statistics(const std::vector<double>& sample) {
    Statistics s;
    s.n = sample.size();
    if (s.n == 0) return s;
    s.mean = mean_of(sample);
    if (s.n < 2) return s;
    const auto n = static_cast<double>(s.n);
    s.sd = std::sqrt(squares_about(sample, *s.mean) / (n - 1.0));
    s.se = *s.sd / std::sqrt(n);
    return s;
}

}  // namespace k3d::optimizer::report
