// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/neat/genome.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "common/log/log.h"

namespace k3d::optimizer::algorithm::neat {

bool Genome::has_node(int id) const {
    const auto at = std::lower_bound(nodes.begin(), nodes.end(), id,
                                     [](const NodeGene& node, int wanted) { return node.id < wanted; });
    return at != nodes.end() && at->id == id;
}

const LinkGene* Genome::find(int from, int to, bool recurrent) const {
    for (const LinkGene& link : links) {
        if (link.from == from && link.to == to && link.recurrent == recurrent) return &link;
    }
    return nullptr;
}

void Genome::insert(const NodeGene& node) {
    K3D_ASSERT(!has_node(node.id));
    const auto at = std::lower_bound(nodes.begin(), nodes.end(), node.id,
                                     [](const NodeGene& n, int wanted) { return n.id < wanted; });
    nodes.insert(at, node);
}

void Genome::insert(const LinkGene& link) {
    const auto at =
        std::lower_bound(links.begin(), links.end(), link.innovation,
                         [](const LinkGene& l, int wanted) { return l.innovation < wanted; });
    K3D_ASSERT(at == links.end() || at->innovation != link.innovation);
    links.insert(at, link);
}

int Genome::hidden() const {
    return static_cast<int>(std::count_if(nodes.begin(), nodes.end(), [](const NodeGene& node) {
        return node.kind == NodeKind::Hidden;
    }));
}

int Genome::enabled_links() const {
    return static_cast<int>(
        std::count_if(links.begin(), links.end(), [](const LinkGene& link) { return link.enabled; }));
}

int Innovations::link(int from, int to, bool recurrent) {
    const Key key{from, to, recurrent};
    const auto [at, is_new] = numbers_.emplace(key, links());
    if (is_new) keys_.push_back(key);
    return at->second;
}

int Innovations::split(int innovation, const Genome& genome) {
    for (int copy = 0;; ++copy) {
        const auto [at, is_new] = splits_.emplace(std::pair{innovation, copy}, next_node_);
        if (is_new) ++next_node_;
        if (!genome.has_node(at->second)) return at->second;
    }
}

bool Innovations::knows(const LinkGene& gene) const {
    return gene.innovation >= 0 && gene.innovation < links() &&
           keys_[static_cast<std::size_t>(gene.innovation)] == Key{gene.from, gene.to, gene.recurrent};
}

bool leads_to(const Genome& genome, int from, int to) {
    std::set<int> seen{from};
    std::vector<int> open{from};
    while (!open.empty()) {
        const int node = open.back();
        open.pop_back();
        if (node == to) return true;
        for (const LinkGene& link : genome.links) {
            if (!link.recurrent && link.from == node && seen.insert(link.to).second) {
                open.push_back(link.to);
            }
        }
    }
    return false;
}

bool is_acyclic(const Genome& genome) {
    std::map<int, int> entering;
    for (const NodeGene& node : genome.nodes) entering[node.id] = 0;
    for (const LinkGene& link : genome.links) {
        if (!link.recurrent) ++entering[link.to];
    }
    std::vector<int> free;
    for (const auto& [node, count] : entering) {
        if (count == 0) free.push_back(node);
    }
    std::size_t done = 0;
    while (!free.empty()) {
        const int node = free.back();
        free.pop_back();
        ++done;
        for (const LinkGene& link : genome.links) {
            if (!link.recurrent && link.from == node && --entering[link.to] == 0) {
                free.push_back(link.to);
            }
        }
    }
    return done == entering.size();
}

void prune(Genome& genome) {
    while (true) {
        std::set<int> entered;
        std::set<int> left;
        for (const LinkGene& link : genome.links) {
            if (link.from == link.to) continue;  // a loop alone feeds nobody
            entered.insert(link.to);
            left.insert(link.from);
        }
        const auto dangles = [&](int id) { return !entered.contains(id) || !left.contains(id); };
        std::set<int> removed;
        for (const NodeGene& node : genome.nodes) {
            if (node.kind == NodeKind::Hidden && dangles(node.id)) removed.insert(node.id);
        }
        if (removed.empty()) return;
        std::erase_if(genome.nodes, [&](const NodeGene& n) { return removed.contains(n.id); });
        std::erase_if(genome.links, [&](const LinkGene& l) {
            return removed.contains(l.from) || removed.contains(l.to);
        });
    }
}

double distance(const Genome& a, const Genome& b, const Settings& settings) {
    int matching = 0;
    int disjoint = 0;
    double difference = 0.0;
    auto i = a.links.begin();
    auto j = b.links.begin();
    while (i != a.links.end() && j != b.links.end()) {
        if (i->innovation == j->innovation) {
            difference += std::abs(i->weight - j->weight);
            ++matching;
            ++i;
            ++j;
        } else if (i->innovation < j->innovation) {
            ++disjoint;
            ++i;
        } else {
            ++disjoint;
            ++j;
        }
    }
    const auto excess = static_cast<double>((a.links.end() - i) + (b.links.end() - j));
    const std::size_t larger = std::max(a.links.size(), b.links.size());
    const double n =
        larger < static_cast<std::size_t>(settings.small_genome) ? 1.0 : static_cast<double>(larger);
    const double mean = matching > 0 ? difference / matching : 0.0;
    return settings.excess * excess / n + settings.disjoint * disjoint / n + settings.weight * mean;
}

}  // namespace k3d::optimizer::algorithm::neat
