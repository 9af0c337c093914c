// SPDX-License-Identifier: BSD-3-Clause
// Mean, standard deviation and standard error of a sample.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace k3d::optimizer::report {

struct Statistics {
    std::size_t n = 0;
    std::optional<double> mean;  ///< none for an empty sample
    std::optional<double> sd;    ///< of the population, estimated with n - 1; none below two values
    std::optional<double> se;    ///< of the mean: sd / sqrt(n)
};

/// Two passes: the sum of squares less the square of the sum would cancel.
inline Statistics statistics(const std::vector<double>& sample) {
    Statistics s;
    s.n = sample.size();
    if (s.n == 0) return s;
    const auto n = static_cast<double>(s.n);
    double sum = 0.0;
    for (const double value : sample) sum += value;
    s.mean = sum / n;
    if (s.n < 2) return s;
    double squares = 0.0;
    for (const double value : sample) squares += (value - *s.mean) * (value - *s.mean);
    s.sd = std::sqrt(squares / (n - 1.0));
    s.se = *s.sd / std::sqrt(n);
    return s;
}

}  // namespace k3d::optimizer::report
