// SPDX-License-Identifier: BSD-3-Clause
// Tests of optimizer/algorithm/neat/species and reproduce: who belongs together, who has children.
#include "optimizer/algorithm/neat/species.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "optimizer/algorithm/neat/interface.h"
#include "optimizer/algorithm/neat/reproduce.h"
#include "optimizer/algorithm/neat/search.h"
#include "optimizer/algorithm/neat/tasks.h"

namespace k3d::optimizer::algorithm::neat {
namespace {

/// Genomes of one structure whose first weight is given: distance 0.4 / 3 per unit.
std::vector<Genome> population_of(const std::vector<double>& weights) {
    Innovations registry(4);
    const Genome base = Interface(testing::empty_network(2, 1)).first_genome(registry);
    std::vector<Genome> population;
    for (const double weight : weights) {
        population.push_back(base);
        population.back().links[0].weight = weight;
    }
    return population;
}

struct Sorted {
    std::vector<Species> species;
    int next_id = 0;
};

void sort_into(Sorted& sorted, const std::vector<Genome>& population,
               const std::vector<double>& fitness, int generation) {
    RandomStream stream(1, "test", "species");
    speciate(sorted.species, sorted.next_id, population, fitness, 3.0, generation, {}, stream);
}

TEST(Speciate, GroupsByDistanceAndOrdersByFitness) {
    Sorted sorted;
    sort_into(sorted, population_of({0.0, 1.0, 100.0, 2.0, 101.0}), {1.0, 5.0, 2.0, 3.0, 4.0}, 0);
    ASSERT_EQ(sorted.species.size(), 2u);
    EXPECT_EQ(sorted.species[0].members, (std::vector<std::size_t>{1, 3, 0}));
    EXPECT_EQ(sorted.species[1].members, (std::vector<std::size_t>{4, 2}));
    EXPECT_EQ(sorted.species[0].best_fitness, 5.0);
    // The second generation: the near species keeps its id, the far one ends, a new one begins.
    sort_into(sorted, population_of({0.5, -100.0, 1.5}), {1.0, 1.0, 1.0}, 1);
    ASSERT_EQ(sorted.species.size(), 2u);
    EXPECT_EQ(sorted.species[0].id, 0);
    EXPECT_EQ(sorted.species[0].improved, 0) << "1.0 is no improvement on 5.0";
    EXPECT_EQ(sorted.species[1].id, 2);
}

Species species_of(int improved, double best, std::vector<std::size_t> members) {
    Species s;
    s.improved = improved;
    s.best_fitness = best;
    s.members = std::move(members);
    return s;
}

Settings with_population(int population) {
    Settings s;
    s.population = population;
    return s;
}

TEST(Allot, FollowsSharedFitness) {
    const std::vector<Species> species = {species_of(10, 4.0, {0, 1}), species_of(10, 6.0, {2})};
    const std::vector<double> fitness = {4.0, 2.0, 6.0};
    // Shared fitness sums: 3 and 6.
    EXPECT_EQ(allot(species, fitness, 10, 0, with_population(9)), (std::vector<int>{3, 6}));
}

TEST(Allot, StagnantSpeciesHaveNoChildrenButTheBestHas) {
    const std::vector<Species> species = {species_of(0, 4.0, {0}), species_of(0, 6.0, {1}),
                                          species_of(9, 2.0, {2})};
    const std::vector<double> fitness = {4.0, 6.0, 2.0};
    EXPECT_EQ(allot(species, fitness, 14, 0, with_population(12)), (std::vector<int>{4, 6, 2}));
    EXPECT_EQ(allot(species, fitness, 15, 0, with_population(12)), (std::vector<int>{0, 9, 3}));
    // All stagnant: the best one lives on, the population does not die out.
    EXPECT_EQ(allot(species, fitness, 99, 0, with_population(12)), (std::vector<int>{0, 12, 0}));
}

TEST(Allot, AStagnantPopulationIsLeftToTheTwoBest) {
    const std::vector<Species> species = {species_of(29, 4.0, {0}), species_of(29, 6.0, {1}),
                                          species_of(29, 2.0, {2})};
    const std::vector<double> fitness = {4.0, 6.0, 2.0};
    EXPECT_EQ(allot(species, fitness, 30, 20, with_population(12)), (std::vector<int>{4, 6, 2}));
    EXPECT_EQ(allot(species, fitness, 30, 21, with_population(10)), (std::vector<int>{4, 6, 0}));
}

TEST(Allot, NegativeAndEqualFitnessAreNoProblem) {
    const std::vector<Species> species = {species_of(1, -4.0, {0}), species_of(1, -6.0, {1})};
    EXPECT_EQ(allot(species, {-4.0, -6.0}, 1, 0, with_population(10)), (std::vector<int>{10, 0}));
    EXPECT_EQ(allot(species, {-4.0, -4.0}, 1, 0, with_population(10)), (std::vector<int>{5, 5}));
    Settings above = with_population(12);
    above.share_above_worst = true;  // worst at a tenth: 1.1 to 0.1
    EXPECT_EQ(allot(species, {1004.0, 1002.0}, 1, 0, above), (std::vector<int>{11, 1}));
}

TEST(FittedThreshold, GivesTheWantedNumberOfSpecies) {
    std::vector<double> weights(60);
    RandomStream stream(4, "test", "weights");
    for (double& weight : weights) weight = stream.normal();
    const std::vector<Genome> population = population_of(weights);
    Settings s;
    EXPECT_EQ(fitted_threshold({}, population, s), 3.0) << "fixed";
    s.target_species = 6;
    const double threshold = fitted_threshold({}, population, s);
    EXPECT_LT(threshold, 1.0);
    Sorted sorted;
    speciate(sorted.species, sorted.next_id, population, weights, threshold, 0, s, stream);
    EXPECT_GE(sorted.species.size(), 5u);
    EXPECT_LE(sorted.species.size(), 6u);
    // A cloud a thousand times as narrow, beside those species' representatives.
    std::vector<Genome> narrow = population_of(weights);
    for (Genome& genome : narrow) genome.links[0].weight = 50.0 + 1e-3 * genome.links[0].weight;
    const double fine = fitted_threshold({}, narrow, s);
    EXPECT_NEAR(fine, 1e-3 * threshold, 1e-4 * threshold);
    EXPECT_LE(fitted_threshold(sorted.species, narrow, s), 1.01 * fine) << "species that end do not count";
    // All alike: any threshold will do, and none is 0.
    EXPECT_GT(fitted_threshold({}, population_of({1.0, 1.0, 1.0}), s), 0.0);
}

TEST(FittedThreshold, NewStructureDoesNotSplinterThePopulation) {
    Settings s;
    s.population = 60;
    s.target_species = 6;
    s.add_node = 0.3;
    s.add_link = 0.3;
    Search search(s, testing::empty_network(4, 1), 3);
    RandomStream stream(5, "test", "fitness");
    for (int generation = 0; generation < 15; ++generation) {
        search.begin(generation);
        std::vector<Outcome> outcomes;
        for (std::size_t i = 0; i < search.size(); ++i) {
            outcomes.push_back({false, {5.0 + stream.normal(), 0.0, 1}});
        }
        search.update(outcomes);
        EXPECT_LE(search.species().size(), 6u) << "generation " << generation;
        EXPECT_GE(search.species().size(), 2u) << "generation " << generation;
    }
}

TEST(Reproduce, CopiesTheChampionOfALargeSpeciesAndDrawsParentsFromTheBest) {
    std::vector<double> weights(20);
    std::iota(weights.begin(), weights.end(), 0.0);
    const std::vector<Genome> population = population_of(weights);
    Sorted sorted;
    sort_into(sorted, population, weights, 0);  // fitness is the weight
    ASSERT_EQ(sorted.species.size(), 1u);
    Settings settings = with_population(20);
    settings.mutate_weights = 0.0;
    settings.add_node = 0.0;
    settings.add_link = 0.0;
    Innovations registry(4);
    Interface(testing::empty_network(2, 1)).first_genome(registry);
    RandomStream stream(2, "test", "reproduce");
    const auto next = reproduce(sorted.species, {20}, population, weights, registry, settings, false, stream);
    ASSERT_EQ(next.size(), 20u);
    EXPECT_EQ(next.front(), population.back());
    for (const Genome& child : next) {
        EXPECT_GE(child.links[0].weight, 16.0) << "a parent outside the best fifth";
    }
    settings.elitism_size = 20;  // not more than 20 members: no copy is owed
    settings.mutate_weights = 1.0;
    const auto mutated =
        reproduce(sorted.species, {20}, population, weights, registry, settings, false, stream);
    EXPECT_NE(mutated.front(), population.back());
}

}  // namespace
}  // namespace k3d::optimizer::algorithm::neat
