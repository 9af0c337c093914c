// SPDX-License-Identifier: BSD-3-Clause
// NEAT on two poles without velocities (Stanley & Miikkulainen 2002, section 4.2.2): a table of
// evaluations and generalisation over seeds. Minutes of work, hence no part of the suite.
// usage: double_pole_bench [SEEDS [MOST_EVALUATIONS]]     default 20 100000
//
// Gruau's damping fitness over 1,000 steps; each generation's best is then to balance for 100,000
// steps and to generalise to 200 of 625 starts. Published: 33,184 evaluations, 286 of 625.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "optimizer/algorithm/neat/double_pole.h"
#include "optimizer/algorithm/neat/search.h"
#include "optimizer/algorithm/neat/tasks.h"

namespace {

using namespace k3d::optimizer;
using namespace k3d::optimizer::algorithm;

constexpr int kWanted = 200;  // of 625 starts

struct Result {
    double evaluations = 0.0;
    int generalised = 0;
    int hidden = 0;
    int links = 0;
    bool solved = false;
};

/// Settings of the paper's appendix for this task: a population of 1,000, larger weight coefficient
/// and threshold, recurrent links.
neat::Settings settings() {
    spec::NeatSpec spec;
    spec.profile = "stanley2002";
    spec.networks = "recurrent";
    spec.population = 1000;
    spec.add_link = 0.3;
    spec.weight_coefficient = 3.0;
    spec.threshold = 4.0;
    neat::Settings s = neat::settings_of(spec);
    // With a coefficient of 3 a threshold of 4 splits the first generation into hundreds of species
    // unless its weights lie close together.
    s.new_weight = 1.0;
    s.perturbation = 0.5;
    return s;
}

Result run(std::uint64_t seed, double most) {
    neat::Search search(settings(), testing::empty_network(3, 1), seed);
    Result result;
    for (int generation = 0; result.evaluations < most; ++generation) {
        search.begin(generation);
        std::vector<Outcome> outcomes;
        for (std::size_t i = 0; i < search.size(); ++i) {
            const k3d::network::Network net(search.network(i), "genome");
            outcomes.push_back({false, {testing::calm_fitness(net), 0.0, 1}});
            result.evaluations += 1.0;
        }
        const std::size_t best = ranking(outcomes).front();
        const k3d::network::Network net(search.network(best), "genome");
        if (testing::balance(net, testing::usual_start(), false, 100000).steps == 100000) {
            result.generalised = std::max(result.generalised, testing::generalisation(net));
            if (result.generalised >= kWanted) {
                result.solved = true;
                result.hidden = search.population()[best].hidden();
                result.links = search.population()[best].enabled_links();
                return result;
            }
        }
        search.update(outcomes);
    }
    return result;
}

}  // namespace

int main(int argc, char** argv) {
    const int seeds = argc > 1 ? std::atoi(argv[1]) : 20;
    const double most = argc > 2 ? std::atof(argv[2]) : 100000.0;
    if (seeds < 1 || most < 1.0) {
        std::fprintf(stderr, "usage: double_pole_bench [SEEDS [MOST_EVALUATIONS]]\n");
        return 2;
    }
    std::vector<double> evaluations;
    double generalised = 0.0;
    int solved = 0;
    std::printf("seed  evaluations  generalised  hidden  links\n");
    for (int seed = 1; seed <= seeds; ++seed) {
        const Result r = run(static_cast<std::uint64_t>(seed), most);
        std::printf("%4d  %11.0f  %7d/625  %6d  %5d%s\n", seed, r.evaluations, r.generalised, r.hidden,
                    r.links, r.solved ? "" : "  not solved");
        std::fflush(stdout);
        evaluations.push_back(r.evaluations);
        if (!r.solved) continue;
        ++solved;
        generalised += r.generalised;
    }
    std::sort(evaluations.begin(), evaluations.end());
    double mean = 0.0;
    for (const double e : evaluations) mean += e / seeds;
    std::printf("solved %d of %d; evaluations: median %.0f, mean %.0f; generalised: mean %.0f of 625\n",
                solved, seeds, evaluations[evaluations.size() / 2], mean,
                solved > 0 ? generalised / solved : 0.0);
    return solved == seeds ? 0 : 1;
}
