// SPDX-License-Identifier: BSD-3-Clause
// Properties of NEAT's operators over many random genomes: the 75 % rule, structure that stays sound,
// populations of exact size.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "optimizer/algorithm/neat/crossover.h"
#include "optimizer/algorithm/neat/mutate.h"
#include "optimizer/algorithm/neat/search.h"
#include "optimizer/algorithm/neat/tasks.h"

namespace k3d::optimizer::algorithm::neat {
namespace {

Settings lively(bool recurrent) {
    Settings s;
    s.population = 40;
    s.recurrent = recurrent;
    s.recurrent_link = recurrent ? 0.4 : 0.0;
    s.add_node = 0.3;
    s.add_link = 0.4;
    s.delete_node = 0.1;
    s.delete_link = 0.15;
    s.enable = 0.2;
    s.interspecies = 0.05;
    s.one_structural_change = false;
    s.activations = {network::Activation::Sigmoid, network::Activation::Tanh};
    s.change_activation = 0.1;
    s.target_species = 5;
    return s;
}

TEST(Crossover, DisablesThreeQuartersOfWhatIsDisabledInEitherParent) {
    Innovations registry(4);
    const Interface interface(testing::empty_network(2, 1));
    const Genome base = interface.first_genome(registry);
    ASSERT_EQ(base.links.size(), 3u);
    Genome a = base;
    Genome b = base;
    a.links[0].enabled = false;  // in one parent
    b.links[1].enabled = false;  // in the other
    a.links[2].enabled = false;  // in both
    b.links[2].enabled = false;
    RandomStream stream(1, "test", "crossover");
    constexpr int kCrossings = 100000;
    std::vector<int> disabled(3, 0);
    for (int i = 0; i < kCrossings; ++i) {
        const Genome child = cross(a, b, {}, stream);
        for (std::size_t k = 0; k < 3; ++k) disabled[k] += child.links[k].enabled ? 0 : 1;
    }
    for (const int count : disabled) EXPECT_NEAR(count, 0.75 * kCrossings, 0.01 * kCrossings);
}

TEST(Crossover, TakesMatchingGenesFromBothAndTheRestFromTheFitter) {
    Innovations registry(4);
    const Interface interface(testing::empty_network(2, 1));
    Genome a = interface.first_genome(registry);
    Genome b = a;
    for (LinkGene& link : a.links) link.weight = 1.0;
    for (LinkGene& link : b.links) link.weight = 2.0;
    RandomStream stream(1, "test", "crossover");
    Settings settings;
    add_node(a, registry, settings, stream);
    add_node(b, registry, settings, stream);
    add_node(b, registry, settings, stream);
    std::set<double> weights;
    for (int i = 0; i < 100; ++i) {
        const Genome child = cross(a, b, settings, stream);
        EXPECT_EQ(child.nodes.size(), a.nodes.size());
        ASSERT_EQ(child.links.size(), a.links.size());
        for (std::size_t k = 0; k < child.links.size(); ++k) {
            EXPECT_EQ(child.links[k].innovation, a.links[k].innovation);
        }
        weights.insert(child.links[0].weight);
    }
    EXPECT_EQ(weights, (std::set<double>{1.0, 2.0}));
    settings.average = 1.0;
    EXPECT_EQ(cross(a, b, settings, stream).links[0].weight, 1.5);
}

TEST(Mutate, NewNodeKeepsTheFlow) {
    Innovations registry(4);
    const Interface interface(testing::empty_network(2, 1));
    Genome g = interface.first_genome(registry);
    for (LinkGene& link : g.links) link.weight = 0.5;
    RandomStream stream(1, "test", "mutate");
    ASSERT_TRUE(add_node(g, registry, {}, stream));
    ASSERT_EQ(g.links.size(), 5u);
    EXPECT_EQ(g.hidden(), 1);
    EXPECT_EQ(g.enabled_links(), 4);
    EXPECT_EQ(g.links[3].weight, 1.0);  // into the new node
    EXPECT_EQ(g.links[4].weight, 0.5);  // out of it: the old weight
    EXPECT_NE(g.links[3].from, 0) << "the bias link was split";
}

/// What must be true of every genome, whatever happened to it.
void expect_sound(const Genome& genome, const Innovations& registry, const Interface& interface,
                  bool recurrent) {
    ASSERT_TRUE(is_acyclic(genome));
    ASSERT_EQ(interface.mismatch(genome), "");
    for (std::size_t i = 0; i < genome.links.size(); ++i) {
        ASSERT_TRUE(registry.knows(genome.links[i]));
        ASSERT_TRUE(recurrent || !genome.links[i].recurrent);
        if (i == 0) continue;
        ASSERT_LT(genome.links[i - 1].innovation, genome.links[i].innovation);
    }
    Genome pruned = genome;
    prune(pruned);
    ASSERT_EQ(pruned, genome) << "a node dangles";
    // The agent's own checks; and its output is fed.
    const network::Definition definition = interface.network(genome);
    const network::Network net(definition, "genome");
    ASSERT_EQ(network::parse(network::to_json(definition), "file"), definition);
}

TEST(Mutate, StructureStaysSoundOverThousandsOfMutations) {
    for (const bool recurrent : {false, true}) {
        const Settings settings = lively(recurrent);
        const Interface interface(testing::empty_network(3, 2));
        Innovations registry(interface.first_new_node());
        RandomStream stream(7, "test", "mutate");
        for (int run = 0; run < 20; ++run) {
            Genome genome = interface.first_genome(registry);
            for (int i = 0; i < 100; ++i) {
                mutate(genome, registry, settings, run % 4 == 3, stream);
                ASSERT_NO_FATAL_FAILURE(expect_sound(genome, registry, interface, recurrent));
            }
        }
    }
}

TEST(Evolve, EveryGenerationIsSoundAndOfExactSize) {
    for (const bool recurrent : {false, true}) {
        const Settings settings = lively(recurrent);
        const Interface interface(testing::empty_network(3, 2));
        Search search(settings, testing::empty_network(3, 2), 5);
        RandomStream luck(3, "test", "fitness");
        std::map<int, std::tuple<int, int, bool>> events;
        for (int generation = 0; generation < 60; ++generation) {
            search.begin(generation);
            std::vector<Outcome> outcomes;
            for (std::size_t i = 0; i < search.size(); ++i) {
                outcomes.push_back({luck.uniform() < 0.05, {luck.normal() * 10.0, 0.0, 1}});
            }
            search.update(outcomes);
            ASSERT_EQ(static_cast<int>(search.size()), settings.population);
            std::size_t members = 0;
            for (const Species& s : search.species()) members += s.members.size();
            ASSERT_EQ(members, search.size());
            for (const Genome& genome : search.population()) {
                ASSERT_NO_FATAL_FAILURE(
                    expect_sound(genome, search.innovations(), interface, recurrent));
                for (const LinkGene& link : genome.links) {
                    const std::tuple event{link.from, link.to, link.recurrent};
                    const auto [at, is_new] = events.emplace(link.innovation, event);
                    ASSERT_EQ(at->second, event) << "innovation " << link.innovation;
                }
            }
        }
        std::set<std::tuple<int, int, bool>> different;
        for (const auto& [innovation, event] : events) different.insert(event);
        EXPECT_EQ(different.size(), events.size()) << "one event has two numbers";
        EXPECT_GT(events.size(), 50u);
    }
}

RC_GTEST_PROP(Apportion, SumsToTheTotalAndFollowsTheShares, ()) {
    std::vector<double> shares;
    for (const int share : *rc::gen::nonEmpty(
             rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1000)))) {
        shares.push_back(0.37 * share);
    }
    const int total = *rc::gen::inRange(0, 500);
    const std::vector<int> parts = apportion(shares, total);
    RC_ASSERT(std::accumulate(parts.begin(), parts.end(), 0) == total);
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double exact = sum > 0.0 ? shares[i] / sum * total
                                       : static_cast<double>(total) / static_cast<double>(parts.size());
        RC_ASSERT(std::abs(parts[i] - exact) < 1.0 + 1e-9);
    }
}

}  // namespace
}  // namespace k3d::optimizer::algorithm::neat
