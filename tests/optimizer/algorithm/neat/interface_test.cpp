// SPDX-License-Identifier: BSD-3-Clause
// Tests of optimizer/algorithm/neat/interface and settings: networks become genomes and come back.
#include "optimizer/algorithm/neat/interface.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "optimizer/algorithm/neat/mutate.h"
#include "optimizer/algorithm/neat/search.h"
#include "optimizer/algorithm/neat/tasks.h"

namespace k3d::optimizer::algorithm::neat {
namespace {

using ::testing::HasSubstr;
using network::Activation;

/// A hand-made network: scaled inputs, a hidden node, a recurrent link.
network::Definition hand_made() {
    network::Definition d;
    d.inputs = {{"near", 0.5, 2.0}, {"far", 0.0, 0.1}};
    d.outputs = {"kick", "hold"};
    d.nodes = {{"h5", Activation::Tanh, -0.25}, {"hold", Activation::Linear, 0.0},
               {"kick", Activation::Sigmoid, 1.5}};
    d.links = {{"near", "h5", 0.1 + 0.2, false}, {"h5", "kick", -2.0, false},
               {"far", "hold", 3.0, false},      {"kick", "h5", 0.5, true}};
    return d;
}

std::vector<double> answers(const network::Definition& d) {
    const network::Network net(d, "network");
    network::State state = net.start();
    std::vector<double> all;
    for (const double x : {-1.0, 0.0, 0.5, 2.0}) {
        const std::vector<double> inputs{x, 1.0 - x};
        for (const double y : net.evaluate(inputs, state)) all.push_back(y);
    }
    return all;
}

TEST(Interface, AHandMadeNetworkKeepsItsAnswers) {
    const Interface interface(hand_made());
    Innovations registry(interface.first_new_node());
    const Genome genome = interface.first_genome(registry);
    EXPECT_EQ(genome.hidden(), 1);
    EXPECT_EQ(interface.mismatch(genome), "");
    const network::Definition back = interface.network(genome);
    EXPECT_EQ(back.inputs, hand_made().inputs);
    EXPECT_EQ(back.outputs, hand_made().outputs);
    EXPECT_EQ(answers(back), answers(hand_made()));
}

TEST(Interface, NamesOfNewNodesAvoidThoseInUse) {
    const Interface interface(hand_made());
    Innovations registry(interface.first_new_node());
    Genome genome = interface.first_genome(registry);
    EXPECT_EQ(interface.first_new_node(), 6);
    network::Definition taken = hand_made();
    taken.inputs[0].name = "h6";
    taken.links[0].from = "h6";
    const Interface other(taken);
    Innovations marks(other.first_new_node());
    genome = other.first_genome(marks);
    RandomStream stream(1, "test", "names");
    ASSERT_TRUE(add_node(genome, marks, {}, stream));
    EXPECT_EQ(other.network(genome).nodes.back().name, "h6_");
    EXPECT_NO_THROW(network::Network(other.network(genome), "network"));
}

TEST(Interface, WithoutLinksEveryInputMeetsEveryOutput) {
    const Interface interface(testing::empty_network(3, 2));
    Innovations registry(interface.first_new_node());
    const Genome genome = interface.first_genome(registry);
    EXPECT_EQ(genome.links.size(), 3u * 2u + 2u);  // and the bias
    EXPECT_EQ(genome.hidden(), 0);
}

TEST(Interface, DisabledLinksAreNoPartOfTheNetwork) {
    const Interface interface(testing::empty_network(2, 1));
    Innovations registry(interface.first_new_node());
    Genome genome = interface.first_genome(registry);
    genome.links[0].enabled = false;
    EXPECT_EQ(interface.network(genome).links.size(), 1u);
    genome.links.back().weight = 0.75;  // the bias
    EXPECT_EQ(interface.network(genome).nodes[0].bias, 0.75);
    genome.links.back().enabled = false;
    EXPECT_EQ(interface.network(genome).nodes[0].bias, 0.0);
}

TEST(Start, FromANetworkTheFirstCandidateIsThatNetwork) {
    Settings settings;
    settings.population = 10;
    settings.recurrent = true;
    settings.start_from_network = true;
    const Search search(settings, hand_made(), 1);
    EXPECT_EQ(answers(search.network(0)), answers(hand_made()));
    EXPECT_NE(answers(search.network(1)), answers(hand_made()));
    EXPECT_EQ(search.population()[1].nodes, search.population()[0].nodes);
    settings.start_from_network = false;
    EXPECT_NE(answers(Search(settings, hand_made(), 1).network(0)), answers(hand_made()));
    settings.recurrent = false;
    EXPECT_THROW(Search(settings, hand_made(), 1), AlgorithmError);
}

TEST(Profiles, TheKeepawayPaperHasSixtyNetworksWithoutHiddenNodes) {
    spec::NeatSpec spec;
    spec.profile = "keepaway_paper";
    Search search(settings_of(spec), testing::empty_network(8, 1), 1);
    RandomStream luck(1, "test", "fitness");
    for (int generation = 0; generation < 20; ++generation) {
        search.begin(generation);
        std::vector<Outcome> outcomes;
        for (std::size_t i = 0; i < search.size(); ++i) outcomes.push_back({false, {luck.normal(), 0.1, 20}});
        search.update(outcomes);
        ASSERT_EQ(search.size(), 60u);
        for (const Genome& genome : search.population()) ASSERT_EQ(genome.hidden(), 0);
    }
    EXPECT_GE(search.species().size(), 3u);
    EXPECT_LE(search.species().size(), 12u);
}

TEST(Profiles, SettingsThatCannotBeAreNamed) {
    const auto error = [](auto change) -> std::string {
        spec::NeatSpec spec;
        change(spec);
        try {
            settings_of(spec);
        } catch (const AlgorithmError& e) {
            return e.what();
        }
        return "no error";
    };
    EXPECT_EQ(error([](auto&) {}), "no error");
    EXPECT_THAT(error([](auto& s) { s.population = 3; }), HasSubstr("neat.population is 3"));
    EXPECT_THAT(error([](auto& s) { s.add_node = -0.5; }), HasSubstr("neat.add_node is -0.5"));
    EXPECT_THAT(error([](auto& s) { s.perturb = -0.5; }), HasSubstr("neat.perturb is -0.5"));
    EXPECT_THAT(error([](auto& s) { s.activations = "sigmoid step"; }), HasSubstr("\"step\""));
    EXPECT_THAT(error([](auto& s) { s.activations = " "; }), HasSubstr("names none"));
    EXPECT_THAT(error([](auto& s) { s.recurrent_link = 0.5; }), HasSubstr("feed_forward"));
    EXPECT_THAT(error([](auto& s) { s.target_species = 200; }), HasSubstr("neat.target_species is 200"));
    spec::NeatSpec spec;
    spec.population = 30;
    spec.target_species = 0;
    spec.add_node = 0.5;
    spec.perturb = 1.0;
    spec.perturbation = 0.25;
    spec.new_weight = 0.75;
    spec.networks = "recurrent";
    const Settings s = settings_of(spec);
    EXPECT_EQ(s.population, 30);
    EXPECT_EQ(s.target_species, 0);
    EXPECT_EQ(s.add_node, 0.5);
    EXPECT_EQ(s.perturb, 1.0);
    EXPECT_EQ(s.perturbation, 0.25);
    EXPECT_EQ(s.new_weight, 0.75);
    EXPECT_TRUE(s.recurrent);
    EXPECT_GT(s.recurrent_link, 0.0);
}

TEST(PhasedSearch, GrowthTurnsIntoPruningAndBack) {
    Settings settings;
    settings.population = 30;
    settings.add_node = 0.4;
    settings.add_link = 0.4;
    settings.complexity_ceiling = 12;
    settings.pruning_patience = 4;
    Search search(settings, testing::empty_network(3, 1), 2);
    RandomStream luck(1, "test", "fitness");
    std::vector<std::string> phases;
    double most = 0.0;
    for (int generation = 0; generation < 150; ++generation) {
        search.begin(generation);
        std::vector<Outcome> outcomes;
        for (std::size_t i = 0; i < search.size(); ++i) outcomes.push_back({false, {luck.uniform(), 0.0, 1}});
        search.update(outcomes);
        nlohmann::json line;
        search.report(line);
        if (phases.empty() || phases.back() != line["phase"]) phases.push_back(line["phase"]);
        most = std::max(most, line["mean_links"].get<double>());
    }
    ASSERT_GE(phases.size(), 4u) << "grow, prune, grow, prune";
    EXPECT_LT(most, 4.0 + 3 * 12.0) << "without pruning it would grow by some links a generation";
}

}  // namespace
}  // namespace k3d::optimizer::algorithm::neat
