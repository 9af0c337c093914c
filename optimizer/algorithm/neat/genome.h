// SPDX-License-Identifier: BSD-3-Clause
// Genomes of NEAT: node genes and link genes with historical marks, and the registry that gives them.
// Paper: Stanley & Miikkulainen 2002, sections 3.1 and 3.2.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "common/network/network.h"
#include "common/random/stream.h"
#include "optimizer/algorithm/neat/settings.h"
#include "optimizer/algorithm/state_json.h"

namespace k3d::optimizer::algorithm::neat {

enum class NodeKind { Bias, Input, Output, Hidden };

/// Ids: 0 the bias, then the inputs, the outputs, and hidden nodes in order of invention.
struct NodeGene {
    int id = 0;
    NodeKind kind = NodeKind::Hidden;
    network::Activation activation = network::Activation::Sigmoid;
    bool operator==(const NodeGene&) const = default;
};

struct LinkGene {
    int innovation = 0;
    int from = 0;
    int to = 0;
    double weight = 0.0;
    bool enabled = true;
    bool recurrent = false;  ///< reads its source's value of the evaluation before
    bool operator==(const LinkGene&) const = default;
};

struct Genome {
    std::vector<NodeGene> nodes;  ///< by id
    std::vector<LinkGene> links;  ///< by innovation
    bool operator==(const Genome&) const = default;

    bool has_node(int id) const;
    const LinkGene* find(int from, int to, bool recurrent) const;
    void insert(const NodeGene& node);  ///< in order; the id must be new
    void insert(const LinkGene& link);  ///< in order; the innovation must be new
    int hidden() const;
    int enabled_links() const;
};

/// The same structural event has the same number, in every genome and generation of a run.
class Innovations {
  public:
    /// `first_node`: id of the first node to be invented.
    explicit Innovations(int first_node) : first_node_(first_node), next_node_(first_node) {}

    int link(int from, int to, bool recurrent);
    /// The node that splits this link; a genome that has it already gets the next copy.
    int split(int innovation, const Genome& genome);

    int links() const { return static_cast<int>(keys_.size()); }
    int next_node() const { return next_node_; }
    /// True if `gene` has the innovation of its structure.
    bool knows(const LinkGene& gene) const;

    nlohmann::json save() const;
    void load(const Reader& reader);

  private:
    using Key = std::tuple<int, int, bool>;
    std::vector<Key> keys_;                          // by innovation
    std::map<Key, int> numbers_;                     // the inverse
    std::map<std::pair<int, int>, int> splits_;      // (innovation, copy) -> node
    int first_node_;
    int next_node_;
};

/// True if, without recurrent links, a path leads from `from` to `to`.
bool leads_to(const Genome& genome, int from, int to);
/// True if the links that are not recurrent form no cycle.
bool is_acyclic(const Genome& genome);
/// Removes hidden nodes that no link enters or none leaves, with their links, until there is none.
void prune(Genome& genome);

/// Compatibility distance: c1 E / N + c2 D / N + c3 mean weight difference (equation 1).
double distance(const Genome& a, const Genome& b, const Settings& settings);

/// {"nodes": [[id, kind, activation], ...], "links": [[innovation, from, to, weight, enabled, recurrent], ...]}
nlohmann::json save(const Genome& genome);
Genome read_genome(const Reader& reader);

}  // namespace k3d::optimizer::algorithm::neat
