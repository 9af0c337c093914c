// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/cmaes/restarts.h"

#include <algorithm>
#include <cmath>

namespace k3d::optimizer::algorithm::cmaes {
namespace {

constexpr int kLargestPopulation = 1 << 20;

int doubled(int population, int times) {
    const double wanted = std::ldexp(population, times);
    return static_cast<int>(std::min<double>(wanted, kLargestPopulation));
}

}  // namespace

void count(Restarts& restarts, const Attempt& attempt, double candidates) {
    if (attempt.small) {
        restarts.used_small += candidates;
    } else {
        restarts.used_large += candidates;
        restarts.last_large = candidates;
    }
}

std::optional<Attempt> next_attempt(const spec::CmaesSpec& spec, Restarts& restarts,
                                    double remaining, RandomStream& stream) {
    Attempt attempt;
    if (spec.restarts == "none") return std::nullopt;
    // BIPOP: the regime that has used less of the budget goes next.
    attempt.small = spec.restarts == "bipop" && restarts.large_restarts > 0 &&
                    restarts.used_small < restarts.used_large;
    if (attempt.small) {
        const int large = doubled(restarts.first_population, restarts.large_restarts);
        const double ratio = 0.5 * large / restarts.first_population;
        const double u = stream.uniform();
        const double v = stream.uniform();
        attempt.population = static_cast<int>(
            std::floor(restarts.first_population * std::pow(ratio, u * u)));
        attempt.sigma = std::pow(10.0, -2.0 * v);
        attempt.candidates = std::max(0.5 * restarts.last_large, 2.0 * attempt.population);
    } else {
        if (restarts.large_restarts >= spec.max_restarts) return std::nullopt;
        restarts.large_restarts += 1;
        attempt.population = doubled(restarts.first_population, restarts.large_restarts);
    }
    if (remaining < 2.0 * attempt.population) return std::nullopt;
    if (std::isfinite(remaining)) {
        attempt.candidates =
            attempt.candidates > 0.0 ? std::min(attempt.candidates, remaining) : remaining;
    }
    return attempt;
}

nlohmann::json save(const Attempt& attempt) {
    return {{"population", attempt.population},
            {"sigma", exact(attempt.sigma)},
            {"small", attempt.small},
            {"candidates", exact(attempt.candidates)}};
}

Attempt read_attempt(const Reader& reader) {
    Attempt attempt{reader["population"].integer(2, kLargestPopulation), reader["sigma"].finite(),
                    reader["small"].flag(), reader["candidates"].finite()};
    if (attempt.sigma <= 0.0) reader["sigma"].fail("is not above 0");
    return attempt;
}

nlohmann::json save(const Restarts& restarts) {
    return {{"first_population", restarts.first_population},
            {"large_restarts", restarts.large_restarts},
            {"used_large", exact(restarts.used_large)},
            {"used_small", exact(restarts.used_small)},
            {"last_large", exact(restarts.last_large)}};
}

Restarts read_restarts(const Reader& reader) {
    return {reader["first_population"].integer(2, kLargestPopulation),
            reader["large_restarts"].integer(0, 1000), reader["used_large"].finite(),
            reader["used_small"].finite(), reader["last_large"].finite()};
}

}  // namespace k3d::optimizer::algorithm::cmaes
