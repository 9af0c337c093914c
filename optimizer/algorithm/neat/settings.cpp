// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/neat/settings.h"

#include <fmt/format.h>

#include <sstream>

#include "optimizer/algorithm/error.h"

namespace k3d::optimizer::algorithm::neat {
namespace {

using network::Activation;

constexpr int kMostGenomes = 10000;

/// The keepaway paper, section 5.3: 60 networks without hidden nodes, whose links and weights change.
Settings keepaway_paper() {
    Settings s;
    s.population = 60;
    s.add_node = 0.0;
    s.target_species = 6;  // a fixed threshold lumps or splinters so small a population
    s.enable = 0.05;
    return s;
}

/// Section 4.1 of the NEAT paper, as for XOR and double pole balancing with velocities.
Settings stanley2002() {
    Settings s;
    s.mate_only = 0.0;
    s.one_structural_change = false;
    s.perturbation = 1.0;
    s.new_weight = 2.0;
    return s;
}

/// What later practice added: a fitted threshold, pruning, several changes at a time.
Settings modern() {
    Settings s;
    s.target_species = 8;
    s.kept_species = 2;
    s.share_above_worst = true;
    s.mate_only = 0.0;
    s.average = 0.2;
    s.perturbation = 1.0;
    s.new_weight = 2.0;
    s.add_node = 0.04;
    s.add_link = 0.08;
    s.delete_node = 0.01;
    s.delete_link = 0.02;
    s.enable = 0.05;
    s.one_structural_change = false;
    s.complexity_ceiling = 30;
    return s;
}

Activation activation_in(const std::string& name) {
    if (const auto activation = network::activation_named(name)) return *activation;
    throw AlgorithmError(fmt::format(
        "neat.activations holds \"{}\"; known: linear, sigmoid, tanh, relu, gauss, sine", name));
}

std::vector<Activation> activations_in(const std::string& text) {
    std::vector<Activation> list;
    std::istringstream words(text);
    for (std::string word; words >> word;) list.push_back(activation_in(word));
    if (list.empty()) throw AlgorithmError(fmt::format("neat.activations is \"{}\", names none", text));
    return list;
}

void override_with(double& setting, double value, const char* name) {
    if (value == -1.0) return;
    if (value < 0.0) {
        throw AlgorithmError(
            fmt::format("neat.{} is {}, allowed is -1 (the profile's) or at least 0", name, value));
    }
    setting = value;
}

}  // namespace

Settings settings_of(const spec::NeatSpec& spec) {
    Settings s;
    if (spec.profile == "keepaway_paper") s = keepaway_paper();
    if (spec.profile == "stanley2002") s = stanley2002();
    if (spec.profile == "modern") s = modern();
    s.start_from_network = spec.start == "network";
    if (spec.networks != "profile") s.recurrent = spec.networks == "recurrent";
    if (!spec.activations.empty()) s.activations = activations_in(spec.activations);
    if (s.activations.size() > 1) s.change_activation = 0.05;
    if (spec.population > 0) s.population = spec.population;
    if (s.population < 4 || s.population > kMostGenomes) {
        throw AlgorithmError(fmt::format("neat.population is {}, allowed is 4 to {}", s.population,
                                         kMostGenomes));
    }
    if (spec.target_species >= 0) s.target_species = spec.target_species;
    if (s.target_species > s.population / 2) {
        throw AlgorithmError(fmt::format("neat.target_species is {}, too many for a population of {}",
                                         s.target_species, s.population));
    }
    if (spec.threshold > 0.0) s.threshold = spec.threshold;
    override_with(s.weight, spec.weight_coefficient, "weight_coefficient");
    override_with(s.perturb, spec.perturb, "perturb");
    override_with(s.perturbation, spec.perturbation, "perturbation");
    override_with(s.new_weight, spec.new_weight, "new_weight");
    override_with(s.add_node, spec.add_node, "add_node");
    override_with(s.add_link, spec.add_link, "add_link");
    override_with(s.delete_node, spec.delete_node, "delete_node");
    override_with(s.delete_link, spec.delete_link, "delete_link");
    if (s.recurrent) s.recurrent_link = 0.5;
    override_with(s.recurrent_link, spec.recurrent_link, "recurrent_link");
    if (!s.recurrent && s.recurrent_link > 0.0) {
        throw AlgorithmError(fmt::format(
            "neat.recurrent_link is {}, but neat.networks is feed_forward", s.recurrent_link));
    }
    if (spec.complexity_ceiling >= 0) s.complexity_ceiling = spec.complexity_ceiling;
    return s;
}

}  // namespace k3d::optimizer::algorithm::neat
