// SPDX-License-Identifier: BSD-3-Clause
// Genomes and the registry of innovations as JSON.
#include <fmt/format.h>

#include <array>
#include <limits>

#include "optimizer/algorithm/neat/genome.h"

namespace k3d::optimizer::algorithm::neat {
namespace {

using nlohmann::json;

constexpr int kMost = std::numeric_limits<int>::max() - 1;
constexpr std::array<const char*, 4> kKinds = {"bias", "input", "output", "hidden"};
NodeKind read_kind(const Reader& reader) {
    const std::string text = reader.text();
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
        if (text == kKinds[i]) return static_cast<NodeKind>(i);
    }
    reader.fail(fmt::format("\"{}\" is no kind of node", text));
}

network::Activation read_activation(const Reader& reader) {
    const std::string text = reader.text();
    if (const auto activation = network::activation_named(text)) return *activation;
    reader.fail(fmt::format("\"{}\" is no activation", text));
}

NodeGene read_node(const Reader& reader) {
    return {reader.entry(0).integer(0, kMost), read_kind(reader.entry(1)),
            read_activation(reader.entry(2))};
}

LinkGene read_link(const Reader& reader, const Genome& genome) {
    const LinkGene link{reader.entry(0).integer(0, kMost), reader.entry(1).integer(0, kMost),
                        reader.entry(2).integer(0, kMost), reader.entry(3).finite(),
                        reader.entry(4).flag(),            reader.entry(5).flag()};
    if (!genome.has_node(link.from)) reader.fail(fmt::format("starts at node {}, which is missing", link.from));
    if (!genome.has_node(link.to)) reader.fail(fmt::format("ends at node {}, which is missing", link.to));
    for (const NodeGene& node : genome.nodes) {
        if (node.id == link.to && (node.kind == NodeKind::Bias || node.kind == NodeKind::Input)) {
            reader.fail(fmt::format("ends at node {}, which is an input", link.to));
        }
    }
    return link;
}

}  // namespace

json save(const Genome& genome) {
    json nodes = json::array();
    for (const NodeGene& node : genome.nodes) {
        nodes.push_back({node.id, kKinds[static_cast<std::size_t>(node.kind)],
                         network::name_of(node.activation)});
    }
    json links = json::array();
    for (const LinkGene& l : genome.links) {
        links.push_back({l.innovation, l.from, l.to, exact(l.weight), l.enabled, l.recurrent});
    }
    return {{"nodes", nodes}, {"links", links}};
}

Genome read_genome(const Reader& reader) {
    Genome genome;
    reader["nodes"].each([&genome](const Reader& entry) {
        const NodeGene node = read_node(entry);
        if (!genome.nodes.empty() && node.id <= genome.nodes.back().id) {
            entry.fail(fmt::format("node {} is out of order", node.id));
        }
        genome.nodes.push_back(node);
    });
    reader["links"].each([&genome](const Reader& entry) {
        const LinkGene link = read_link(entry, genome);
        if (!genome.links.empty() && link.innovation <= genome.links.back().innovation) {
            entry.fail(fmt::format("innovation {} is out of order", link.innovation));
        }
        genome.links.push_back(link);
    });
    if (!is_acyclic(genome)) reader["links"].fail("form a cycle of links that are not recurrent");
    return genome;
}

json Innovations::save() const {
    json links = json::array();
    for (const auto& [from, to, recurrent] : keys_) links.push_back({from, to, recurrent});
    json splits = json::array();
    for (const auto& [key, node] : splits_) splits.push_back({key.first, key.second, node});
    return {{"links", links}, {"splits", splits}, {"next_node", next_node_}};
}

void Innovations::load(const Reader& reader) {
    keys_.clear();
    numbers_.clear();
    splits_.clear();
    next_node_ = reader["next_node"].integer(first_node_, kMost);
    const int last = next_node_ - 1;
    reader["links"].each([&](const Reader& entry) {
        const Key key{entry.entry(0).integer(0, last), entry.entry(1).integer(0, last),
                      entry.entry(2).flag()};
        if (!numbers_.emplace(key, links()).second) entry.fail("is there twice");
        keys_.push_back(key);
    });
    reader["splits"].each([&](const Reader& entry) {
        const std::pair key{entry.entry(0).integer(0, links() - 1), entry.entry(1).integer(0, kMost)};
        const int node = entry.entry(2).integer(first_node_, last);
        if (!splits_.emplace(key, node).second) entry.fail("is there twice");
    });
}

}  // namespace k3d::optimizer::algorithm::neat
