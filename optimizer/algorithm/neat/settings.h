// SPDX-License-Identifier: BSD-3-Clause
// Every setting of NEAT, and the profiles that set them all at once.
// Source: K. Stanley & R. Miikkulainen, Evolving Neural Networks through Augmenting Topologies,
// Evolutionary Computation 10(2):99-127, 2002 (section 4.1); where it is silent, its first program.
#pragma once

#include <vector>

#include "common/network/network.h"
#include "optimizer/spec/algorithm_spec.h"

namespace k3d::optimizer::algorithm::neat {

struct Settings {
    int population = 150;
    bool start_from_network = false;  ///< vary the start network's own weights instead of drawing new
    bool recurrent = false;           ///< recurrent links may grow
    std::vector<network::Activation> activations{network::Activation::Sigmoid};  ///< of new nodes

    // Distance and species.
    double excess = 1.0;    ///< c1
    double disjoint = 1.0;  ///< c2
    double weight = 0.4;    ///< c3
    int small_genome = 20;  ///< N of the distance is 1 if both have fewer links
    double threshold = 3.0;
    int target_species = 0;  ///< > 0: the threshold is the least that leaves no more than so many

    // Who has children.
    double survival = 0.2;         ///< best share of a species that does
    int stagnation = 15;           ///< generations without improvement after which a species has none
    int kept_species = 1;          ///< so many best species are exempt
    int population_stagnation = 20;  ///< then only the two best species reproduce; 0: never
    int elitism_size = 5;          ///< the champion of a larger species is copied unchanged
    bool share_above_worst = false;  ///< fitness shares count from the worst of the generation, not 0

    // How children differ.
    double mutate_only = 0.25;     ///< share of children of one parent
    double mate_only = 0.2;        ///< share of children of two parents that are not mutated
    double interspecies = 0.001;
    double average = 0.0;          ///< share of crossovers that average matching weights
    double disabled = 0.75;        ///< chance that a gene disabled in either parent is in the child
    double mutate_weights = 0.8;   ///< chance per child
    double perturb = 0.9;          ///< share of its weights that change by a bit; the others are new
    double perturbation = 0.5;     ///< standard deviation of that change
    double new_weight = 1.0;       ///< standard deviation of new weights
    double weight_limit = 8.0;     ///< weights stay within +- this
    double add_node = 0.03;
    double add_link = 0.05;
    double delete_node = 0.0;
    double delete_link = 0.0;
    double recurrent_link = 0.0;   ///< share of recurrent ones among new links
    double enable = 0.0;           ///< chance per child that one disabled link comes back
    double change_activation = 0.0;
    bool one_structural_change = true;  ///< a child with new structure keeps its weights

    // Phased search: grow until the mean number of links is this far above its floor, then prune until
    // it stops falling, and so on (C. Green, 2004). 0: only grow.
    int complexity_ceiling = 0;
    int pruning_patience = 10;     ///< generations without a smaller mean that end the pruning
};

/// The profile with the fields of the specification that are not at their defaults. Throws
/// AlgorithmError naming the setting and its value.
Settings settings_of(const spec::NeatSpec& spec);

}  // namespace k3d::optimizer::algorithm::neat
