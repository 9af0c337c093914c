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

/// A network is sought, by neat: inputs, outputs and activations are those of `start`; whether its links'
/// weights matter is NeatSpec::start's choice. Who searches the weights of a network as it is has a vector
/// problem: problem_of() in experiment.h.
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
    int halving_episodes = 0;     ///< further training episodes shared out by sequential halving
    void describe(config::Fields& f);
};

/// Hansen, The CMA Evolution Strategy: A Tutorial, arXiv 1604.00772.
struct CmaesSpec {
    int population = 0;             ///< 0: 4 + floor(3 ln n)
    std::string covariance = "full";  ///< full or separable
    bool active = true;             ///< negative weights for the worse half
    std::string restarts = "none";  ///< none, ipop or bipop
    int max_restarts = 9;
    std::string noise = "none";     ///< none, or reevaluate: more episodes while noise hides ranks
    int max_episodes = 100;         ///< of one candidate in one generation, when `noise` is reevaluate
    double reliability = 0.5;       ///< share of the spread of fitness that must not be noise
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

/// Stanley & Miikkulainen, Evolutionary Computation 10(2), 2002. The profile sets everything that
/// the fields below leave at their defaults.
struct NeatSpec {
    std::string profile = "modern";  ///< keepaway_paper, stanley2002 or modern
    std::string start = "random";    ///< random weights on the start network's links, or network: its own
    std::string networks = "profile";  ///< feed_forward, recurrent
    std::string activations;         ///< of new hidden nodes, e.g. "sigmoid tanh"; empty: the profile's
    int population = 0;              ///< 0: the profile's
    int target_species = -1;         ///< -1: the profile's; 0: the threshold stays; else it leaves no more
    double threshold = 0.0;          ///< compatibility distance of one species; 0: the profile's
    double weight_coefficient = -1.0;  ///< c3 of the distance; this and those below: -1: the profile's
    double perturb = -1.0;           ///< share of a child's weights that change by a bit; the others are new
    double perturbation = -1.0;      ///< standard deviation of a weight's change
    double new_weight = -1.0;        ///< standard deviation of new weights
    double add_node = -1.0;          ///< chance per child
    double add_link = -1.0;
    double delete_node = -1.0;
    double delete_link = -1.0;
    double recurrent_link = -1.0;    ///< share of recurrent ones among new links
    int complexity_ceiling = -1;     ///< phased search: links above the smallest mean; 0: only grow
    void describe(config::Fields& f);
};

/// Each has a section of its name in [algorithm].
inline const std::vector<std::string> kAlgorithmNames{"cmaes", "cross_entropy", "random_search",
                                                      "neat"};

/// The [algorithm] section of an experiment.
struct AlgorithmSpec {
    std::string name = "cmaes";      ///< cmaes, cross_entropy, random_search or neat
    int max_generations = 1000000;   ///< the run ends after these
    double max_episodes = 0;         ///< no generation begins after these; 0: no limit
    double target = 1e300;  ///< the run ends when its champion has this fitness
    SamplingSpec sampling;
    CmaesSpec cmaes;
    CrossEntropySpec cross_entropy;
    RandomSearchSpec random_search;
    NeatSpec neat;
    void describe(config::Fields& f);
};

}  // namespace k3d::optimizer::spec
