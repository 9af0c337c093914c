// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/neat/mutate.h"

#include <algorithm>
#include <cmath>

namespace k3d::optimizer::algorithm::neat {
namespace {

constexpr int kTries = 20;  // pairs of nodes that are looked at for a new link

template <class Value>
const Value& pick(const std::vector<Value>& values, RandomStream& stream) {
    return values[static_cast<std::size_t>(stream.below(static_cast<int>(values.size())))];
}

bool is_fed(const NodeGene& node) {
    return node.kind == NodeKind::Output || node.kind == NodeKind::Hidden;
}

double limited(double weight, const Settings& settings) {
    return std::clamp(weight, -settings.weight_limit, settings.weight_limit);
}

/// Indices of links with this property.
template <class Property>
std::vector<std::size_t> links_that(const Genome& genome, Property property) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < genome.links.size(); ++i) {
        if (property(genome.links[i])) found.push_back(i);
    }
    return found;
}

bool every_output_is_fed(const Genome& genome) {
    return std::all_of(genome.nodes.begin(), genome.nodes.end(), [&genome](const NodeGene& node) {
        return node.kind != NodeKind::Output ||
               std::any_of(genome.links.begin(), genome.links.end(),
                           [&node](const LinkGene& l) { return l.to == node.id && l.enabled; });
    });
}

}  // namespace

void mutate_weights(Genome& genome, const Settings& settings, RandomStream& stream) {
    for (LinkGene& link : genome.links) {
        const bool bit = stream.uniform() < settings.perturb;
        const double draw = stream.normal();
        const double weight =
            bit ? link.weight + settings.perturbation * draw : settings.new_weight * draw;
        link.weight = limited(weight, settings);
    }
}

bool add_node(Genome& genome, Innovations& innovations, const Settings& settings,
              RandomStream& stream) {
    // A bias reaches every node directly; a node between would only dilute it.
    const auto open =
        links_that(genome, [](const LinkGene& link) { return link.enabled && link.from != 0; });
    if (open.empty()) return false;
    LinkGene& old = genome.links[pick(open, stream)];
    old.enabled = false;
    const LinkGene split = old;
    const int node = innovations.split(split.innovation, genome);
    genome.insert(NodeGene{node, NodeKind::Hidden, pick(settings.activations, stream)});
    // The delay of a recurrent link stays once: on the way out of the new node.
    genome.insert({innovations.link(split.from, node, false), split.from, node, 1.0, true, false});
    genome.insert({innovations.link(node, split.to, split.recurrent), node, split.to, split.weight,
                   true, split.recurrent});
    return true;
}

bool add_link(Genome& genome, Innovations& innovations, const Settings& settings,
              RandomStream& stream) {
    std::vector<NodeGene> fed;
    for (const NodeGene& node : genome.nodes) {
        if (is_fed(node)) fed.push_back(node);
    }
    const bool recurrent = settings.recurrent && stream.uniform() < settings.recurrent_link;
    for (int i = 0; i < kTries; ++i) {
        const NodeGene& from = recurrent ? pick(fed, stream) : pick(genome.nodes, stream);
        const NodeGene& to = pick(fed, stream);
        if (genome.find(from.id, to.id, recurrent) != nullptr) continue;
        if (!recurrent && leads_to(genome, to.id, from.id)) continue;
        const double weight = limited(settings.new_weight * stream.normal(), settings);
        genome.insert({innovations.link(from.id, to.id, recurrent), from.id, to.id, weight, true,
                       recurrent});
        return true;
    }
    return false;
}

bool delete_node(Genome& genome, RandomStream& stream) {
    std::vector<int> hidden;
    for (const NodeGene& node : genome.nodes) {
        if (node.kind == NodeKind::Hidden) hidden.push_back(node.id);
    }
    if (hidden.empty()) return false;
    const int gone = pick(hidden, stream);
    Genome smaller = genome;
    std::erase_if(smaller.nodes, [gone](const NodeGene& n) { return n.id == gone; });
    std::erase_if(smaller.links, [gone](const LinkGene& l) { return l.from == gone || l.to == gone; });
    prune(smaller);
    if (!every_output_is_fed(smaller)) return false;
    genome = std::move(smaller);
    return true;
}

bool delete_link(Genome& genome, RandomStream& stream) {
    if (genome.links.empty()) return false;
    const auto gone = stream.below(static_cast<int>(genome.links.size()));
    Genome smaller = genome;
    smaller.links.erase(smaller.links.begin() + gone);
    prune(smaller);
    if (!every_output_is_fed(smaller)) return false;
    genome = std::move(smaller);
    return true;
}

bool enable_link(Genome& genome, RandomStream& stream) {
    const auto off = links_that(genome, [](const LinkGene& link) { return !link.enabled; });
    if (off.empty()) return false;
    genome.links[pick(off, stream)].enabled = true;
    return true;
}

bool change_activation(Genome& genome, const Settings& settings, RandomStream& stream) {
    std::vector<NodeGene*> hidden;
    for (NodeGene& node : genome.nodes) {
        if (node.kind == NodeKind::Hidden) hidden.push_back(&node);
    }
    if (hidden.empty()) return false;
    pick(hidden, stream)->activation = pick(settings.activations, stream);
    return true;
}

void mutate(Genome& genome, Innovations& innovations, const Settings& settings, bool pruning,
            RandomStream& stream) {
    const auto happens = [&stream](double chance) { return stream.uniform() < chance; };
    bool grown = false;
    if (!pruning) {
        if (happens(settings.add_node)) {
            grown = add_node(genome, innovations, settings, stream);
        }
        if (!(grown && settings.one_structural_change) && happens(settings.add_link)) {
            grown = add_link(genome, innovations, settings, stream) || grown;
        }
    }
    // Pruning deletes about as often as growth adds.
    if (happens(pruning ? std::max(settings.delete_node, settings.add_node) : settings.delete_node)) {
        delete_node(genome, stream);
    }
    if (happens(pruning ? std::max(settings.delete_link, settings.add_link) : settings.delete_link)) {
        delete_link(genome, stream);
    }
    if (grown && settings.one_structural_change) return;
    if (happens(settings.mutate_weights)) mutate_weights(genome, settings, stream);
    if (!pruning && happens(settings.enable)) enable_link(genome, stream);
    if (happens(settings.change_activation)) change_activation(genome, settings, stream);
}

}  // namespace k3d::optimizer::algorithm::neat
