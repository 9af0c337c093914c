// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/neat/species.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "common/log/log.h"

namespace k3d::optimizer::algorithm::neat {
namespace {

constexpr double kLeastThreshold = 1e-6;
constexpr double kMostThreshold = 1e6;

/// True if this threshold leaves no more species than wanted.
bool is_few(const std::vector<Species>& species, const std::vector<Genome>& population,
            double threshold, const Settings& settings) {
    std::vector<const Genome*> founders;
    for (const Species& s : species) founders.push_back(&s.representative);
    std::vector<bool> has_members(founders.size(), false);
    int count = 0;
    for (const Genome& genome : population) {
        const auto home = std::find_if(founders.begin(), founders.end(), [&](const Genome* founder) {
            return distance(genome, *founder, settings) < threshold;
        });
        const auto index = static_cast<std::size_t>(home - founders.begin());
        if (home == founders.end()) {
            founders.push_back(&genome);
            has_members.push_back(false);
        }
        if (has_members[index]) continue;
        has_members[index] = true;
        if (++count > settings.target_species) return false;
    }
    return true;
}

/// Indices of species from the one with the best member to the one with the worst best.
std::vector<std::size_t> by_best_member(const std::vector<Species>& species,
                                        const std::vector<double>& fitness) {
    std::vector<std::size_t> order(species.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return fitness[species[a].members.front()] > fitness[species[b].members.front()];
    });
    return order;
}

}  // namespace

void speciate(std::vector<Species>& species, int& next_id, const std::vector<Genome>& population,
              const std::vector<double>& fitness, double threshold, int generation,
              const Settings& settings, RandomStream& stream) {
    for (Species& s : species) s.members.clear();
    for (std::size_t i = 0; i < population.size(); ++i) {
        const auto home = std::find_if(species.begin(), species.end(), [&](const Species& s) {
            return distance(population[i], s.representative, settings) < threshold;
        });
        if (home != species.end()) {
            home->members.push_back(i);
        } else {
            species.push_back({next_id++, generation, generation,
                               -std::numeric_limits<double>::infinity(), population[i], {i}});
        }
    }
    std::erase_if(species, [](const Species& s) { return s.members.empty(); });
    for (Species& s : species) {
        const int member = stream.below(static_cast<int>(s.members.size()));
        s.representative = population[s.members[static_cast<std::size_t>(member)]];
        std::stable_sort(s.members.begin(), s.members.end(),
                         [&fitness](std::size_t a, std::size_t b) { return fitness[a] > fitness[b]; });
        const double best = fitness[s.members.front()];
        if (best > s.best_fitness) {
            s.best_fitness = best;
            s.improved = generation;
        }
    }
}

double fitted_threshold(const std::vector<Species>& species, const std::vector<Genome>& population,
                        const Settings& settings) {
    if (settings.target_species == 0) return settings.threshold;
    const auto few = [&](double threshold) {
        return is_few(species, population, threshold, settings);
    };
    double high = kLeastThreshold;
    while (!few(high) && high < kMostThreshold) high *= 2.0;
    double low = 0.5 * high;
    // A larger threshold gives fewer species, roughly: halve the interval a fixed number of times.
    for (int i = 0; i < 12; ++i) {
        const double middle = 0.5 * (low + high);
        (few(middle) ? high : low) = middle;
    }
    return high;
}

std::vector<int> allot(const std::vector<Species>& species, const std::vector<double>& fitness,
                       int generation, int stalled, const Settings& settings) {
    K3D_ASSERT(!species.empty());
    const std::vector<std::size_t> order = by_best_member(species, fitness);
    std::vector<bool> breeds(species.size());
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
        const Species& s = species[order[rank]];
        const bool fresh = generation - s.improved < settings.stagnation;
        breeds[order[rank]] = fresh || static_cast<int>(rank) < settings.kept_species;
    }
    if (settings.population_stagnation > 0 && stalled > settings.population_stagnation) {
        std::fill(breeds.begin(), breeds.end(), false);
        for (std::size_t rank = 0; rank < std::min<std::size_t>(2, order.size()); ++rank) {
            breeds[order[rank]] = true;
        }
    }
    const double worst = *std::min_element(fitness.begin(), fitness.end());
    const double best = *std::max_element(fitness.begin(), fitness.end());
    // Shares must not be negative. Counted from the worst they do not depend on fitness's zero; the
    // worst itself still gets a little.
    double zero = std::min(0.0, worst);
    if (settings.share_above_worst) zero = worst - 0.1 * (best - worst);
    std::vector<double> shares(species.size(), 0.0);
    std::vector<double> even(species.size(), 0.0);
    for (std::size_t i = 0; i < species.size(); ++i) {
        if (!breeds[i]) continue;
        even[i] = 1.0;
        for (const std::size_t member : species[i].members) shares[i] += fitness[member] - zero;
        shares[i] /= static_cast<double>(species[i].members.size());
    }
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    return apportion(sum > 0.0 && std::isfinite(sum) ? shares : even, settings.population);
}

std::vector<int> apportion(const std::vector<double>& shares, int total) {
    K3D_ASSERT(!shares.empty());
    double sum = 0.0;
    for (const double share : shares) {
        K3D_ASSERT(share >= 0.0);
        sum += share;
    }
    std::vector<int> parts(shares.size());
    std::vector<double> rest(shares.size());
    int left = total;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const double exact = sum > 0.0 ? shares[i] / sum * total
                                       : static_cast<double>(total) / static_cast<double>(shares.size());
        parts[i] = std::min(left, static_cast<int>(std::floor(exact)));
        rest[i] = exact - parts[i];
        left -= parts[i];
    }
    std::vector<std::size_t> order(shares.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&rest](std::size_t a, std::size_t b) { return rest[a] > rest[b]; });
    for (std::size_t i = 0; left > 0; i = (i + 1) % order.size()) {
        parts[order[i]] += 1;
        --left;
    }
    return parts;
}

nlohmann::json save(const Species& s) {
    return {{"id", s.id},
            {"born", s.born},
            {"improved", s.improved},
            {"best_fitness", exact(s.best_fitness)},
            {"representative", save(s.representative)},
            {"members", s.members}};
}

Species read_species(const Reader& reader, std::size_t population) {
    constexpr int kMost = std::numeric_limits<int>::max() - 1;
    Species s{reader["id"].integer(0, kMost), reader["born"].integer(0, kMost),
              reader["improved"].integer(0, kMost), reader["best_fitness"].number(),
              read_genome(reader["representative"]), {}};
    reader["members"].each([&](const Reader& entry) {
        const int last = static_cast<int>(population) - 1;
        s.members.push_back(static_cast<std::size_t>(entry.integer(0, last)));
    });
    return s;
}

}  // namespace k3d::optimizer::algorithm::neat
