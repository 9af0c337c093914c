// SPDX-License-Identifier: BSD-3-Clause
// The next generation from the species of this one. Paper: section 4.1.
#pragma once

#include <vector>

#include "optimizer/algorithm/neat/species.h"

namespace k3d::optimizer::algorithm::neat {

/// Exactly `settings.population` genomes; `children`: per species, as allot() gives them.
std::vector<Genome> reproduce(const std::vector<Species>& species, const std::vector<int>& children,
                              const std::vector<Genome>& population,
                              const std::vector<double>& fitness, Innovations& innovations,
                              const Settings& settings, bool pruning, RandomStream& stream);

}  // namespace k3d::optimizer::algorithm::neat
