// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/score.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/math/sample.h"
#include "optimizer/algorithm/seeds.h"

namespace k3d::optimizer::algorithm {
namespace {

/// Standard error of the mean, from the sum of squared deviations from it.
double error_of(double squares, int n) {
    if (n < 2) return 0.0;
    return std::sqrt(squares / (static_cast<double>(n) * static_cast<double>(n - 1)));
}

}  // namespace

Score score_of(const std::vector<double>& values) {
    const int n = static_cast<int>(values.size());
    const double mean = mean_of(values);
    return {mean, error_of(squares_about(values, mean), n), n};
}

std::vector<std::size_t> ranking(const std::vector<Outcome>& outcomes) {
    std::vector<std::size_t> order(outcomes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&outcomes](std::size_t a, std::size_t b) {
        if (outcomes[a].failed != outcomes[b].failed) return outcomes[b].failed;
        return !outcomes[a].failed && outcomes[a].score.mean > outcomes[b].score.mean;
    });
    return order;
}

double reliability(const std::vector<Outcome>& outcomes) {
    std::vector<double> means;
    double noise = 0.0;
    for (const Outcome& outcome : outcomes) {
        if (outcome.failed) continue;
        means.push_back(outcome.score.mean);
        noise += outcome.score.se * outcome.score.se;
    }
    if (means.size() < 2 || noise == 0.0) return 1.0;
    noise /= static_cast<double>(means.size());
    const Score all = score_of(means);
    const double variance = all.se * all.se * all.n;
    if (!(variance > noise)) return 0.0;
    return 1.0 - noise / variance;
}

nlohmann::json save(const Score& score) {
    return {{"mean", exact(score.mean)}, {"se", exact(score.se)}, {"n", score.n}};
}

Score read_score(const Reader& reader) {
    const Score score{reader["mean"].finite(), reader["se"].finite(),
                      reader["n"].integer(1, kMaxEpisodes)};
    if (score.se < 0.0) reader["se"].fail("is below 0");
    return score;
}

}  // namespace k3d::optimizer::algorithm
