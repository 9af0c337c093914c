// SPDX-License-Identifier: BSD-3-Clause
// NEAT, NeuroEvolution of Augmenting Topologies, as a search over networks.
// Source: K. Stanley & R. Miikkulainen, Evolutionary Computation 10(2):99-127, 2002.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optimizer/algorithm/neat/interface.h"
#include "optimizer/algorithm/neat/reproduce.h"
#include "optimizer/algorithm/score.h"

namespace k3d::optimizer::algorithm::neat {

/// Growth and pruning in turn, by the mean number of links of a genome.
struct Phase {
    bool pruning = false;
    double floor = 0.0;    ///< smallest mean since growth began
    double leanest = 0.0;  ///< smallest mean of this pruning
    int since = 0;         ///< generation in which that was reached
};

class Search {
  public:
    Search(const Settings& settings, const network::Definition& start, std::uint64_t seed);

    void begin(int generation) { generation_ = generation; }
    std::size_t size() const { return population_.size(); }
    network::Definition network(std::size_t candidate) const;
    void update(const std::vector<Outcome>& outcomes);
    std::optional<std::string> stopped() const { return std::nullopt; }
    void report(nlohmann::json& line) const { line.update(report_); }
    nlohmann::json save() const;
    void load(const Reader& reader);

    const Settings& settings() const { return settings_; }
    /// Candidate 0 of the first generation is the start network unchanged.
    bool begins_with_start() const { return settings_.start_from_network; }
    const std::vector<Genome>& population() const { return population_; }
    const std::vector<Species>& species() const { return species_; }
    const Innovations& innovations() const { return innovations_; }

  private:
    void found();
    void turn_phase();
    void describe(const std::vector<int>& children, double threshold);

    Settings settings_;
    Interface interface_;
    std::uint64_t seed_;
    Innovations innovations_;
    std::vector<Genome> population_;  // the generation under evaluation
    std::vector<Species> species_;    // of the generation before
    int next_species_ = 0;
    int generation_ = 0;
    double best_fitness_;
    int improved_ = 0;  // generation of the best fitness so far
    Phase phase_;
    nlohmann::json report_ = nlohmann::json::object();
};

}  // namespace k3d::optimizer::algorithm::neat
