// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/cmaes/stop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace k3d::optimizer::algorithm::cmaes {
namespace {

constexpr std::size_t kLongest = 20000;      // generations kept
constexpr double kWorstCondition = 1e14;     // of the covariance
constexpr double kGrowth = 1e4;              // of the largest deviation: the start was far too small

std::size_t window(const Constants& c) {
    return 10 + static_cast<std::size_t>(std::ceil(30.0 * c.n / c.population));
}

double median_of(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// No progress between the older and the newer end of a long history, by best and by median.
bool stagnates(const Constants& c, const History& h) {
    const std::size_t least = 120 + static_cast<std::size_t>(std::ceil(30.0 * c.n / c.population));
    const auto fifth = static_cast<std::size_t>(h.generations) / 5;
    const std::size_t length = std::min({std::max(least, fifth), kLongest, h.best.size()});
    if (length < least) return false;
    const auto gained = [length](const std::deque<double>& values) {
        const auto end = static_cast<std::ptrdiff_t>(length);
        const auto third = static_cast<std::ptrdiff_t>(0.3 * static_cast<double>(length));
        const double older = median_of({values.end() - end, values.end() - end + third});
        const double newer = median_of({values.end() - third, values.end()});
        return newer > older;
    };
    return !gained(h.best) && !gained(h.median);
}

/// A tenth of a deviation along an axis, or a fifth along a coordinate, is lost in rounding.
std::optional<std::string> no_effect(const Constants& c, const Distribution& d) {
    if (!c.separable) {
        const int axis = d.generation % c.n;
        const Eigen::VectorXd step = 0.1 * d.sigma * d.lengths[axis] * d.axes.col(axis);
        if (d.mean == d.mean + step) return "no_effect_axis";
    }
    const Eigen::VectorXd reach = 0.2 * d.sigma * deviations(c, d);
    for (int i = 0; i < c.n; ++i) {
        if (d.mean[i] == d.mean[i] + reach[i]) return "no_effect_coordinate";
    }
    return std::nullopt;
}

}  // namespace

void remember(History& history, const Constants& c, double best, double median) {
    history.best.push_back(best);
    history.median.push_back(median);
    history.generations += 1;
    const std::size_t keep =
        std::min(kLongest, std::max<std::size_t>(120 + 3 * window(c),
                                                 static_cast<std::size_t>(history.generations) / 5 + 1));
    while (history.best.size() > keep) history.best.pop_front();
    while (history.median.size() > keep) history.median.pop_front();
}

std::optional<std::string> reason_to_stop(const Constants& c, const Distribution& d,
                                          const StopRules& rules, const History& history,
                                          double current_range) {
    const Eigen::VectorXd deviation = d.sigma * deviations(c, d);
    if (!deviation.allFinite() || !d.mean.allFinite() || d.sigma > 1e20 ||
        d.sigma * d.lengths.maxCoeff() > kGrowth * rules.first_sigma) {
        return "divergence";
    }
    if (deviation.maxCoeff() < rules.tolerance_x &&
        (d.sigma * d.path_c).cwiseAbs().maxCoeff() < rules.tolerance_x) {
        return "tolerance_x";
    }
    const std::size_t recent = window(c);
    if (history.best.size() > recent) {
        const auto begin = history.best.end() - static_cast<std::ptrdiff_t>(recent);
        const auto [low, high] = std::minmax_element(begin, history.best.end());
        if (*high - *low < rules.tolerance_fitness && current_range < rules.tolerance_fitness) {
            return "tolerance_fitness";
        }
    }
    const double ratio = d.lengths.maxCoeff() / d.lengths.minCoeff();
    if (ratio * ratio > kWorstCondition) return "condition";
    if (stagnates(c, history)) return "stagnation";
    return no_effect(c, d);
}

nlohmann::json save(const History& history) {
    return {{"best", exact(std::vector<double>(history.best.begin(), history.best.end()))},
            {"median", exact(std::vector<double>(history.median.begin(), history.median.end()))},
            {"generations", history.generations}};
}

History read_history(const Reader& reader) {
    History history;
    const std::vector<double> best = reader["best"].finite_list();
    if (best.size() > kLongest) reader["best"].fail("is too long");
    const std::vector<double> median = reader["median"].finite_list(best.size());
    history.best.assign(best.begin(), best.end());
    history.median.assign(median.begin(), median.end());
    history.generations = reader["generations"].integer(static_cast<int>(best.size()),
                                                        std::numeric_limits<int>::max() - 1);
    return history;
}

}  // namespace k3d::optimizer::algorithm::cmaes
