// SPDX-License-Identifier: BSD-3-Clause
// Between network files and genomes: a network of given inputs and outputs gives the first genome, and
// every genome gives a network that the agent loads.
#pragma once

#include <map>
#include <string>

#include "optimizer/algorithm/neat/genome.h"

namespace k3d::optimizer::algorithm::neat {

class Interface {
  public:
    explicit Interface(network::Definition start);

    int inputs() const { return static_cast<int>(start_.inputs.size()); }
    int outputs() const { return static_cast<int>(start_.outputs.size()); }
    int first_new_node() const;  ///< ids below are the bias and the nodes of the start network

    /// The start network as a genome, a link from the bias to each of its nodes; a start network without
    /// links gets all from inputs to outputs, with weight 0.
    Genome first_genome(Innovations& innovations) const;
    /// Enabled links only. New hidden nodes are called "h" and their number.
    network::Definition network(const Genome& genome) const;
    /// Empty if the genome has these inputs and outputs, else what is wrong with it.
    std::string mismatch(const Genome& genome) const;

  private:
    std::string name_of(int id) const;

    network::Definition start_;
    std::map<std::string, int> ids_;  // of the start network's inputs and nodes
    std::vector<std::string> names_;  // by id
    std::map<int, network::Activation> activations_;
};

}  // namespace k3d::optimizer::algorithm::neat
