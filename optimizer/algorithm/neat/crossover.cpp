// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/neat/crossover.h"

#include <algorithm>

namespace k3d::optimizer::algorithm::neat {

Genome cross(const Genome& fitter, const Genome& other, const Settings& settings,
             RandomStream& stream) {
    Genome child = fitter;
    const bool average = stream.uniform() < settings.average;
    auto match = other.links.begin();
    for (LinkGene& gene : child.links) {
        match = std::find_if(match, other.links.end(), [&gene](const LinkGene& l) {
            return l.innovation >= gene.innovation;
        });
        if (match == other.links.end()) break;
        if (match->innovation != gene.innovation) continue;
        const bool disabled = !gene.enabled || !match->enabled;
        const bool from_other = stream.uniform() < 0.5;
        if (average) {
            gene.weight = 0.5 * (gene.weight + match->weight);
        } else if (from_other) {
            gene.weight = match->weight;
        }
        gene.enabled = !(disabled && stream.uniform() < settings.disabled);
    }
    auto twin = other.nodes.begin();
    for (NodeGene& node : child.nodes) {
        twin = std::find_if(twin, other.nodes.end(),
                            [&node](const NodeGene& n) { return n.id >= node.id; });
        if (twin == other.nodes.end()) break;
        const bool hidden = node.kind == NodeKind::Hidden;
        if (hidden && twin->id == node.id && stream.uniform() < 0.5) node.activation = twin->activation;
    }
    return child;
}

}  // namespace k3d::optimizer::algorithm::neat
