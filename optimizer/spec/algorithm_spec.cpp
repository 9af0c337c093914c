// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/spec/algorithm_spec.h"

namespace k3d::optimizer::spec {
namespace {

constexpr double kManyEpisodes = 1 << 20;
constexpr double kManyCandidates = 100000;

}  // namespace

void SamplingSpec::describe(config::Fields& f) {
    f.integer("episodes", episodes, {1, kManyEpisodes}, "", "of every candidate of a generation");
    f.integer("halving_episodes", halving_episodes, {0, 1e9}, "",
              "further ones in a generation, for its best candidates by sequential halving");
    f.integer("validation_episodes", validation_episodes, {0, kManyEpisodes}, "",
              "of a finalist, on validation seeds; 0: fitness has no noise, the best is the champion");
    f.integer("validate_every", validate_every, {1, 1e9}, "", "generations between validations");
    f.integer("finalists", finalists, {1, 1000}, "", "candidates of a generation that are validated");
}

void CmaesSpec::describe(config::Fields& f) {
    f.integer("population", population, {0, kManyCandidates}, "", "0: 4 + floor(3 ln n)");
    f.text("covariance", covariance, {"full", "separable"}, "what is learned of the parameters");
    f.boolean("active", active, "the worse half pushes away");
    f.text("restarts", restarts, {"none", "ipop", "bipop"}, "after the search has stopped");
    f.integer("max_restarts", max_restarts, {0, 1000}, "", "with a larger population");
    f.text("noise", noise, {"none", "reevaluate"}, "reevaluate: more episodes where noise hides ranks");
    f.integer("max_episodes", max_episodes, {2, kManyEpisodes}, "",
              "of one candidate, if noise is reevaluate");
    f.number("reliability", reliability, {0.01, 0.99}, "",
             "share of the spread of fitness that must not be noise, if noise is reevaluate");
    f.number("tolerance_x", tolerance_x, {0.0, 1.0}, "", "stop below these steps, in first deviations");
    f.number("tolerance_fitness", tolerance_fitness, {0.0, 1e300}, "",
             "stop when the best fitness stayed within this for long");
}

void CrossEntropySpec::describe(config::Fields& f) {
    f.integer("population", population, {4, kManyCandidates}, "", "candidates a generation");
    f.number("elite", elite, {0.001, 0.9}, "", "share of the population the next one is fitted to");
    f.number("smoothing", smoothing, {0.01, 1.0}, "", "weight of the new fit against the old one");
    f.number("least_deviation", least_deviation, {0.0, 1.0}, "", "floor, in first deviations");
}

void RandomSearchSpec::describe(config::Fields& f) {
    f.integer("population", population, {1, kManyCandidates}, "", "candidates a generation");
    f.text("distribution", distribution, {"normal", "uniform"},
           "normal about the start, or uniform within the bounds");
}

void NeatSpec::describe(config::Fields& f) {
    f.text("profile", profile, {"keepaway_paper", "stanley2002", "modern"},
           "sets what the fields below leave at their defaults");
    f.text("start", start, {"random", "network"},
           "random weights on the links of the start network, or its own weights, varied");
    f.text("networks", networks, {"profile", "feed_forward", "recurrent"}, "which may grow");
    f.text("activations", activations, {}, "of new hidden nodes, e.g. \"sigmoid tanh\"");
    f.integer("population", population, {0, kManyCandidates}, "", "0: the profile's");
    f.integer("target_species", target_species, {-1, 1000}, "",
              "the threshold leaves at most so many; 0: it stays; -1: the profile's");
    f.number("threshold", threshold, {0.0, 1e6}, "", "distance within a species; 0: the profile's");
    f.number("weight_coefficient", weight_coefficient, {-1.0, 1e6}, "",
             "c3 of the distance; -1: the profile's");
    f.number("perturb", perturb, {-1.0, 1.0}, "",
             "share of a child's weights that change by a bit, the others are drawn anew; -1: the profile's");
    f.number("perturbation", perturbation, {-1.0, 1e6}, "",
             "standard deviation of a weight's change; -1: the profile's");
    f.number("new_weight", new_weight, {-1.0, 1e6}, "",
             "standard deviation of new weights; -1: the profile's");
    f.number("add_node", add_node, {-1.0, 1.0}, "", "chance per child; -1: the profile's");
    f.number("add_link", add_link, {-1.0, 1.0}, "", "chance per child; -1: the profile's");
    f.number("delete_node", delete_node, {-1.0, 1.0}, "", "chance per child; -1: the profile's");
    f.number("delete_link", delete_link, {-1.0, 1.0}, "", "chance per child; -1: the profile's");
    f.number("recurrent_link", recurrent_link, {-1.0, 1.0}, "",
             "share of recurrent ones among new links; -1: the profile's");
    f.integer("complexity_ceiling", complexity_ceiling, {-1, 1000000}, "",
              "mean links above the leanest generation's at which growth turns into pruning; 0: never");
}

void AlgorithmSpec::describe(config::Fields& f) {
    f.text("name", name, kAlgorithmNames, "the algorithm");
    f.integer("max_generations", max_generations, {1, 1e9}, "", "the run ends after these");
    f.number("max_episodes", max_episodes, {0.0, 1e15}, "",
             "no generation begins after these; 0: no limit");
    f.number("target", target, {-1e300, 1e300}, "", "the run ends when its champion is this good");
    f.section("sampling", sampling);
    f.section("cmaes", cmaes);
    f.section("cross_entropy", cross_entropy);
    f.section("random_search", random_search);
    f.section("neat", neat);
}

}  // namespace k3d::optimizer::spec
