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

/// The threshold that sorts this population into the wanted number of species, or as near as it gets;
/// the settings' own if it is fixed.
double first_threshold(const std::vector<Genome>& population, const Settings& settings);

/// The threshold for the next generation: unchanged if it is fixed.
double next_threshold(double threshold, std::size_t species, const Settings& settings);

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
