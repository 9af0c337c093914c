// SPDX-License-Identifier: BSD-3-Clause
// When one attempt of CMA-ES has nothing more to find (tutorial, appendix B.3).
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "optimizer/algorithm/cmaes/distribution.h"

namespace k3d::optimizer::algorithm::cmaes {

struct StopRules {
    double tolerance_x = 1e-12;        ///< in first deviations
    double tolerance_fitness = 1e-12;
    double first_sigma = 1.0;          ///< of this attempt
};

/// Best and median fitness of past generations, newest last.
struct History {
    std::deque<double> best;
    std::deque<double> median;
    int generations = 0;  ///< seen in all, also those no longer kept
};

/// Adds a generation, and forgets those no rule looks back to.
void remember(History& history, const Constants& c, double best, double median);

/// The reason, or none: tolerance_x, tolerance_fitness, stagnation, divergence, condition,
/// no_effect_axis, no_effect_coordinate. `current_range`: best less worst fitness of the newest
/// generation. A flat generation alone is no reason: whole-number fitness is often flat.
std::optional<std::string> reason_to_stop(const Constants& c, const Distribution& d,
                                          const StopRules& rules, const History& history,
                                          double current_range);

nlohmann::json save(const History& history);
History read_history(const Reader& reader);

}  // namespace k3d::optimizer::algorithm::cmaes
