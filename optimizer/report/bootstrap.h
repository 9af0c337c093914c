// SPDX-License-Identifier: BSD-3-Clause
// The bootstrap: how far a figure of a sample would spread if the sample were drawn again.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "common/random/stream.h"

namespace k3d::optimizer::report {

struct Interval {
    double low = 0.0, high = 0.0;
};

/// 95 % interval (percentiles) of what `figure` makes of as many indices below `n` as there are,
/// drawn with replacement. Draws of which it makes nothing are left out; none if that is so of all.
inline std::optional<Interval> bootstrap_95(
    std::size_t n, RandomStream stream,
    const std::function<std::optional<double>(const std::vector<std::size_t>&)>& figure) {
    constexpr int kDraws = 10000;
    std::vector<std::size_t> drawn(n);
    std::vector<double> figures;
    for (int draw = 0; draw < kDraws; ++draw) {
        for (std::size_t& k : drawn)
            k = static_cast<std::size_t>(stream.below(static_cast<int>(n)));
        if (const auto value = figure(drawn)) figures.push_back(*value);
    }
    if (figures.empty()) return std::nullopt;
    std::sort(figures.begin(), figures.end());
    const auto at = [&](double share) {
        return figures[static_cast<std::size_t>(share * static_cast<double>(figures.size() - 1))];
    };
    return Interval{at(0.025), at(0.975)};
}

}  // namespace k3d::optimizer::report
