// SPDX-License-Identifier: BSD-3-Clause
// What the next attempt of CMA-ES starts with.
// Sources: IPOP: A. Auger & N. Hansen, CEC 2005. BIPOP: N. Hansen, GECCO workshop 2009.
#pragma once

#include <cstdint>
#include <optional>

#include "common/random/stream.h"
#include "optimizer/algorithm/state_json.h"
#include "optimizer/spec/algorithm_spec.h"

namespace k3d::optimizer::algorithm::cmaes {

struct Attempt {
    int population = 0;
    double sigma = 1.0;       ///< first step size, in first deviations
    bool small = false;       ///< of BIPOP's second regime
    double candidates = 0.0;  ///< it ends after these; 0: no limit of its own
    bool operator==(const Attempt&) const = default;
};

/// Candidates used by the attempts so far, by regime.
struct Restarts {
    int first_population = 0;
    int large_restarts = 0;     ///< times the population was doubled
    double used_large = 0.0;    ///< by all attempts that are not small
    double used_small = 0.0;
    double last_large = 0.0;    ///< by the newest large attempt
    bool operator==(const Restarts&) const = default;
};

/// Counts an attempt that has ended.
void count(Restarts& restarts, const Attempt& attempt, double candidates);

/// None: no restart is left. `remaining`: candidates the budget still pays for (infinite without one);
/// no attempt is given more, and none begins that could not complete two generations.
std::optional<Attempt> next_attempt(const spec::CmaesSpec& spec, Restarts& restarts,
                                    double remaining, RandomStream& stream);

nlohmann::json save(const Attempt& attempt);
Attempt read_attempt(const Reader& reader);
nlohmann::json save(const Restarts& restarts);
Restarts read_restarts(const Reader& reader);

}  // namespace k3d::optimizer::algorithm::cmaes
