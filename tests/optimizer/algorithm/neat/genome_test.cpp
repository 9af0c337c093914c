// SPDX-License-Identifier: BSD-3-Clause
// Tests of optimizer/algorithm/neat/genome: innovations, distance, cycles, pruning, bits.
#include "optimizer/algorithm/neat/genome.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace k3d::optimizer::algorithm::neat {
namespace {

using ::testing::HasSubstr;

/// Bias 0, inputs 1 and 2, output 3, and hidden nodes from 4 on.
Genome genome_of(const std::vector<LinkGene>& links, int hidden = 0) {
    Genome g;
    g.nodes = {{0, NodeKind::Bias, network::Activation::Linear},
               {1, NodeKind::Input, network::Activation::Linear},
               {2, NodeKind::Input, network::Activation::Linear},
               {3, NodeKind::Output, network::Activation::Sigmoid}};
    for (int i = 0; i < hidden; ++i) {
        g.nodes.push_back({4 + i, NodeKind::Hidden, network::Activation::Sigmoid});
    }
    g.links = links;
    return g;
}

TEST(Innovations, SameEventSameNumber) {
    Innovations registry(4);
    const int first = registry.link(1, 3, false);
    EXPECT_NE(registry.link(2, 3, false), first);
    EXPECT_EQ(registry.link(1, 3, false), first);
    EXPECT_NE(registry.link(1, 3, true), first) << "a recurrent link is another structure";
    EXPECT_NE(registry.link(3, 1, false), first) << "direction counts";
    const Genome plain = genome_of({{first, 1, 3, 0.5, true, false}});
    const int node = registry.split(first, plain);
    EXPECT_EQ(registry.split(first, plain), node) << "in another genome: the same event";
    Genome has = plain;
    has.insert(NodeGene{node, NodeKind::Hidden, network::Activation::Sigmoid});
    EXPECT_NE(registry.split(first, has), node) << "a second split of one genome: a new node";
}

TEST(Innovations, SavedRegistryKnowsItsEvents) {
    Innovations registry(4);
    const int link = registry.link(1, 3, false);
    const Genome genome = genome_of({{link, 1, 3, 0.5, true, false}});
    const int node = registry.split(link, genome);
    const nlohmann::json json = registry.save();
    Innovations again(4);
    again.load(Reader(json, "state", ""));
    EXPECT_EQ(again.link(1, 3, false), link);
    EXPECT_EQ(again.split(link, genome), node);
    EXPECT_EQ(again.next_node(), registry.next_node());
    EXPECT_TRUE(again.knows({link, 1, 3, 9.0, false, false}));
    EXPECT_FALSE(again.knows({link, 2, 3, 9.0, false, false}));
}

TEST(Distance, FollowsEquationOne) {
    Settings settings;
    settings.excess = 2.0;
    settings.disjoint = 3.0;
    settings.weight = 0.5;
    const Genome a = genome_of({{0, 1, 3, 1.0, true, false}, {1, 2, 3, 2.0, true, false}}, 1);
    const Genome b = genome_of({{0, 1, 3, 2.5, true, false},
                                {2, 1, 4, 1.0, true, false},
                                {3, 4, 3, 1.0, true, false},
                                {4, 0, 3, 1.0, true, false}}, 1);
    // Innovation 1 is disjoint; 2, 3 and 4 are excess; weights of 0 differ by 1.5.
    EXPECT_DOUBLE_EQ(distance(a, b, settings), 2.0 * 3 + 3.0 * 1 + 0.5 * 1.5);
    EXPECT_DOUBLE_EQ(distance(b, a, settings), distance(a, b, settings));
    EXPECT_EQ(distance(a, a, settings), 0.0);
    settings.small_genome = 3;  // now the larger genome's four genes count
    EXPECT_DOUBLE_EQ(distance(a, b, settings), 2.0 * 3 / 4 + 3.0 * 1 / 4 + 0.5 * 1.5);
}

TEST(Genome, CyclesAndWaysAreFound) {
    Genome g = genome_of({{0, 1, 4, 1.0, true, false}, {1, 4, 5, 1.0, true, false},
                          {2, 5, 3, 1.0, true, false}}, 2);
    EXPECT_TRUE(is_acyclic(g));
    EXPECT_TRUE(leads_to(g, 1, 3));
    EXPECT_FALSE(leads_to(g, 5, 4));
    Genome recurrent = g;
    recurrent.insert(LinkGene{3, 5, 4, 1.0, true, true});
    EXPECT_TRUE(is_acyclic(recurrent));
    g.insert(LinkGene{3, 5, 4, 1.0, false, false});
    EXPECT_FALSE(is_acyclic(g)) << "a disabled link may come back";
}

TEST(Genome, PruningFollowsTheChain) {
    // 1 -> 4 -> 5 leads nowhere; 6 is fed by nobody; 7 only by itself.
    Genome g = genome_of({{0, 1, 3, 1.0, true, false},
                          {1, 1, 4, 1.0, true, false},
                          {2, 4, 5, 1.0, true, false},
                          {3, 6, 3, 1.0, true, false},
                          {4, 7, 7, 1.0, true, true},
                          {5, 7, 3, 1.0, true, false}}, 4);
    prune(g);
    EXPECT_EQ(g.hidden(), 0);
    ASSERT_EQ(g.links.size(), 1u);
    EXPECT_EQ(g.links[0].innovation, 0);
}

TEST(Genome, SavedBitsAreTheSame) {
    const Genome g = genome_of({{0, 1, 4, 0.1 + 0.2, true, false}, {3, 4, 3, -1.0 / 3.0, false, false},
                                {7, 3, 4, 1e-300, true, true}}, 1);
    const nlohmann::json json = nlohmann::json::parse(save(g).dump());
    EXPECT_EQ(read_genome(Reader(json, "file", "")), g);
}

TEST(Genome, BadOnesSayWhatIsWrong) {
    const nlohmann::json good =
        save(genome_of({{0, 1, 4, 0.5, true, false}, {1, 4, 3, 0.5, true, false}}, 1));
    const auto error = [&good](auto change) -> std::string {
        nlohmann::json json = good;
        change(json);
        try {
            read_genome(Reader(json, "file", "genome"));
        } catch (const AlgorithmError& e) {
            return e.what();
        }
        return "no error";
    };
    EXPECT_EQ(error([](auto&) {}), "no error");
    EXPECT_THAT(error([](auto& j) { j["links"][0][1] = 9; }), HasSubstr("genome.links[0]: starts at node 9"));
    EXPECT_THAT(error([](auto& j) { j["links"][0][2] = 2; }), HasSubstr("ends at node 2, which is an input"));
    EXPECT_THAT(error([](auto& j) { j["links"][0][3] = "nan"; }), HasSubstr("genome.links[0][3]"));
    EXPECT_THAT(error([](auto& j) { j["links"][1][0] = 0; }), HasSubstr("innovation 0 is out of order"));
    EXPECT_THAT(error([](auto& j) { j["nodes"][1][0] = 0; }), HasSubstr("node 0 is out of order"));
    EXPECT_THAT(error([](auto& j) { j["nodes"][1][1] = "axon"; }), HasSubstr("\"axon\" is no kind of node"));
    EXPECT_THAT(error([](auto& j) { j["nodes"][4][2] = "step"; }), HasSubstr("\"step\" is no activation"));
    EXPECT_THAT(error([](auto& j) { j["links"][0].erase(5); }), HasSubstr("has 5 entries, 6 are needed"));
    EXPECT_THAT(error([](auto& j) { j["links"].push_back({2, 3, 4, 1.0, true, false}); }),
                HasSubstr("cycle"));
}

}  // namespace
}  // namespace k3d::optimizer::algorithm::neat
