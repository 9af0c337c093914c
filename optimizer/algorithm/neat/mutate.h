// SPDX-License-Identifier: BSD-3-Clause
// Mutations of a genome. Those of structure return false, and change nothing, where none is possible.
// Paper: section 3.1; deletions: as later programs have them.
#pragma once

#include "optimizer/algorithm/neat/genome.h"

namespace k3d::optimizer::algorithm::neat {

void mutate_weights(Genome& genome, const Settings& settings, RandomStream& stream);
/// Splits an enabled link: it is disabled; weight 1 leads into the new node, the old weight out of it.
bool add_node(Genome& genome, Innovations& innovations, const Settings& settings,
              RandomStream& stream);
/// A link between two nodes that have none of its kind; never closes a cycle of links that are not
/// recurrent.
bool add_link(Genome& genome, Innovations& innovations, const Settings& settings,
              RandomStream& stream);
bool delete_node(Genome& genome, RandomStream& stream);
/// Deletes a link and what dangles without it; every output keeps a link.
bool delete_link(Genome& genome, RandomStream& stream);
bool enable_link(Genome& genome, RandomStream& stream);
bool change_activation(Genome& genome, const Settings& settings, RandomStream& stream);

/// All of it, as the settings say. `pruning`: only what makes the genome smaller, and weights.
void mutate(Genome& genome, Innovations& innovations, const Settings& settings, bool pruning,
            RandomStream& stream);

}  // namespace k3d::optimizer::algorithm::neat
