// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/neat/interface.h"

#include <fmt/format.h>

#include <algorithm>

#include "optimizer/algorithm/error.h"

namespace k3d::optimizer::algorithm::neat {

Interface::Interface(network::Definition start) : start_(std::move(start)) {
    names_.push_back("bias");
    const auto number = [this](const std::string& name) {
        ids_.emplace(name, static_cast<int>(names_.size()));
        names_.push_back(name);
    };
    const auto node_of = [this](const std::string& name) {
        return std::find_if(start_.nodes.begin(), start_.nodes.end(),
                            [&name](const network::Node& n) { return n.name == name; });
    };
    for (const network::Input& input : start_.inputs) number(input.name);
    for (const std::string& output : start_.outputs) {
        if (ids_.contains(output)) {
            throw AlgorithmError(fmt::format("start network: output \"{}\" is there twice", output));
        }
        number(output);
        activations_[ids_.at(output)] = node_of(output)->activation;
    }
    for (const network::Node& node : start_.nodes) {
        if (ids_.contains(node.name)) continue;
        number(node.name);
        activations_[ids_.at(node.name)] = node.activation;
    }
}

int Interface::first_new_node() const { return static_cast<int>(names_.size()); }

Genome Interface::first_genome(Innovations& innovations) const {
    Genome genome;
    for (int id = 0; id < first_new_node(); ++id) {
        NodeGene node{id, NodeKind::Hidden, network::Activation::Linear};
        if (id == 0) node.kind = NodeKind::Bias;
        if (id > 0 && id <= inputs()) node.kind = NodeKind::Input;
        if (id > inputs() && id <= inputs() + outputs()) node.kind = NodeKind::Output;
        if (const auto at = activations_.find(id); at != activations_.end()) node.activation = at->second;
        genome.nodes.push_back(node);
    }
    const auto add = [&](int from, int to, double weight, bool recurrent) {
        const int innovation = innovations.link(from, to, recurrent);
        if (genome.find(from, to, recurrent) != nullptr) {
            throw AlgorithmError(fmt::format("start network: link \"{}\" -> \"{}\" is there twice",
                                             name_of(from), name_of(to)));
        }
        genome.insert({innovation, from, to, weight, true, recurrent});
    };
    for (const network::Link& link : start_.links) {
        add(ids_.at(link.from), ids_.at(link.to), link.weight, link.recurrent);
    }
    if (start_.links.empty()) {
        for (int output = inputs() + 1; output <= inputs() + outputs(); ++output) {
            for (int input = 1; input <= inputs(); ++input) add(input, output, 0.0, false);
        }
    }
    for (const network::Node& node : start_.nodes) add(0, ids_.at(node.name), node.bias, false);
    return genome;
}

std::string Interface::name_of(int id) const {
    if (id < first_new_node()) return names_[static_cast<std::size_t>(id)];
    std::string name = fmt::format("h{}", id);
    while (ids_.contains(name)) name += "_";
    return name;
}

network::Definition Interface::network(const Genome& genome) const {
    network::Definition d;
    d.description = "grown by NEAT";
    d.inputs = start_.inputs;
    d.outputs = start_.outputs;
    for (const NodeGene& node : genome.nodes) {
        if (node.kind != NodeKind::Output && node.kind != NodeKind::Hidden) continue;
        double bias = 0.0;
        for (const LinkGene& link : genome.links) {
            if (link.enabled && link.from == 0 && link.to == node.id) bias += link.weight;
        }
        d.nodes.push_back({name_of(node.id), node.activation, bias});
    }
    for (const LinkGene& link : genome.links) {
        if (!link.enabled || link.from == 0) continue;
        d.links.push_back({name_of(link.from), name_of(link.to), link.weight, link.recurrent});
    }
    return d;
}

std::string Interface::mismatch(const Genome& genome) const {
    const int fixed = 1 + inputs() + outputs();
    if (static_cast<int>(genome.nodes.size()) < fixed) return "lacks inputs or outputs";
    for (int id = 0; id < static_cast<int>(genome.nodes.size()); ++id) {
        const NodeGene& node = genome.nodes[static_cast<std::size_t>(id)];
        NodeKind kind = NodeKind::Hidden;
        if (id == 0) kind = NodeKind::Bias;
        if (id > 0 && id <= inputs()) kind = NodeKind::Input;
        if (id > inputs() && id < fixed) kind = NodeKind::Output;
        if (node.kind != kind || (id < fixed && node.id != id)) {
            return fmt::format("node {} does not fit the start network's inputs and outputs", node.id);
        }
    }
    return {};
}

}  // namespace k3d::optimizer::algorithm::neat
