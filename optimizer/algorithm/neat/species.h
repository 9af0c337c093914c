// SPDX-License-Identifier: BSD-3-Clause
// Species: who belongs together, who shares fitness, who may have how many children.
// Paper: sections 3.3 and 4.1.
#pragma once

#include <vector>

#include "optimizer/algorithm/neat/genome.h"

namespace k3d::optimizer::algorithm::neat {

struct Species {
    int id = 0;
    int born = 0;              ///< generation
    int improved = 0;          ///< generation of its best fitness so far
    double best_fitness = 0.0;
    Genome representative;
    std::vector<std::size_t> members;  ///< of the present generation, best first
};

/// Sorts the population into species: each genome joins the first whose representative is nearer than
/// the threshold, or founds one. Species without members end. Then each takes a random member as
/// its next representative, and its members are put in order of fitness.
void speciate(std::vector<Species>& species, int& next_id, const std::vector<Genome>& population,
              const std::vector<double>& fitness, double threshold, int generation,
              const Settings& settings, RandomStream& stream);

/// The least threshold, roughly, by which `speciate` would sort this population into no more than the
/// wanted number of species; the settings' own if it is fixed. Sought anew for each generation: a
/// link more is a step of c1 or c2, far above what weights differ by, and one that followed in small
/// steps would let every new structure found a species for dozens of generations.
double fitted_threshold(const std::vector<Species>& species, const std::vector<Genome>& population,
                        const Settings& settings);

/// Children per species, in all exactly the population: in proportion to shared fitness, none for
/// stagnant species. `stalled`: generations since the whole population improved.
std::vector<int> allot(const std::vector<Species>& species, const std::vector<double>& fitness,
                       int generation, int stalled, const Settings& settings);

/// Parts of `total` in proportion to `shares` (>= 0), which sum to it exactly: largest remainders,
/// then first come. Equal parts if all shares are 0.
std::vector<int> apportion(const std::vector<double>& shares, int total);

nlohmann::json save(const Species& species);
Species read_species(const Reader& reader, std::size_t population);

}  // namespace k3d::optimizer::algorithm::neat
