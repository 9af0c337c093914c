// SPDX-License-Identifier: BSD-3-Clause
// What an optimisation run searches (parameters or a network) and how: one struct per algorithm.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "common/config/fields.h"
#include "common/network/network.h"

namespace k3d::optimizer::spec {

/// One number that is tuned, in the units of the program that takes it.
struct Parameter {
    std::string name;         ///< e.g. a config path of the agent, "walk.step_height"
    double start = 0.0;       ///< where the search begins; lies within the bounds
    double deviation = 1.0;   ///< standard deviation of the first samples, > 0
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    bool integer = false;     ///< candidates carry whole numbers
    bool frozen = false;      ///< keeps `start` in every candidate
    bool operator==(const Parameter&) const = default;
};

/// A vector of numbers is sought, by cmaes, cross_entropy or random_search.
using VectorProblem = std::vector<Parameter>;

/// A network is sought, by neat. Its inputs, outputs and activations are those of `start`; whether its
/// links and weights matter is NeatSpec::start's choice.
struct NetworkProblem {
    network::Definition start;
    bool operator==(const NetworkProblem&) const = default;
};

using Problem = std::variant<VectorProblem, NetworkProblem>;

/// How noisy fitness is met, by every algorithm.
struct SamplingSpec {
    int episodes = 1;             ///< of every candidate, on the generation's own training seeds
    int validation_episodes = 0;  ///< per finalist, on validation seeds; 0: fitness has no noise
    int validate_every = 1;       ///< generations from one validation to the next
    int finalists = 4;            ///< best candidates of a generation that are validated
    void describe(config::Fields& f);
};

/// Hansen, The CMA Evolution Strategy: A Tutorial, arXiv 1604.00772.
struct CmaesSpec {
    int population = 0;             ///< 0: 4 + floor(3 ln n)
    std::string covariance = "full";  ///< full or separable
    bool active = true;             ///< negative weights for the worse half
    std::string restarts = "none";  ///< none, ipop or bipop
    int max_restarts = 9;
    std::string noise = "none";     ///< none, reevaluate: more episodes while ranks are uncertain
    int max_episodes = 100;         ///< of one candidate, when `noise` asks for more
    double tolerance_x = 1e-12;     ///< stop when steps are this small, in first deviations
    double tolerance_fitness = 1e-12;  ///< stop when fitness hardly changed for long
    void describe(config::Fields& f);
};

/// Rubinstein 1999; de Boer et al. 2005: a normal distribution refitted to an elite.
struct CrossEntropySpec {
    int population = 50;
    double elite = 0.2;         ///< share of the population
    double smoothing = 0.7;     ///< weight of the new fit
    double least_deviation = 1e-3;  ///< in first deviations; keeps the search alive
    void describe(config::Fields& f);
};

struct RandomSearchSpec {
    int population = 20;
    std::string distribution = "normal";  ///< normal around the start, or uniform within bounds
    void describe(config::Fields& f);
};

/// Stanley & Miikkulainen, Evolutionary Computation 10(2), 2002. A profile sets all other fields.
struct NeatSpec {
    std::string profile = "modern";  ///< keepaway_paper, stanley2002 or modern
    std::string start = "random";    ///< random weights on the start network's links, or network: its own
    int population = 0;              ///< 0: the profile's
    int target_species = 0;          ///< 0: the profile's; > 0: the threshold follows this number
    void describe(config::Fields& f);
};

/// The [algorithm] section of an experiment.
struct AlgorithmSpec {
    std::string name = "cmaes";      ///< cmaes, cross_entropy, random_search or neat
    int max_generations = 1000000;   ///< the run ends after these
    std::uint64_t max_episodes = 0;  ///< no generation begins after these; 0: no limit
    double target = std::numeric_limits<double>::infinity();  ///< the run ends when a champion has it
    SamplingSpec sampling;
    CmaesSpec cmaes;
    CrossEntropySpec cross_entropy;
    RandomSearchSpec random_search;
    NeatSpec neat;
    void describe(config::Fields& f);
};

}  // namespace k3d::optimizer::spec
