// SPDX-License-Identifier: BSD-3-Clause
// Crossover by historical marks. Paper: section 3.2, figure 4.
#pragma once

#include "optimizer/algorithm/neat/genome.h"

namespace k3d::optimizer::algorithm::neat {

/// Matching genes come from either parent at random (or, for a share `settings.average` of all
/// crossovers, with the mean weight); disjoint and excess genes from `fitter`. A matching gene that
/// is disabled in either parent is disabled in the child with probability `settings.disabled`.
/// The child has the nodes and links of `fitter`, and so forms no cycle.
Genome cross(const Genome& fitter, const Genome& other, const Settings& settings,
             RandomStream& stream);

}  // namespace k3d::optimizer::algorithm::neat
