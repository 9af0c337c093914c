// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/neat/search.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "common/log/log.h"
#include "optimizer/algorithm/neat/mutate.h"

namespace k3d::optimizer::algorithm::neat {
namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();

/// Failed candidates count as the worst of those that have a result; 0 if nobody has.
std::vector<double> fitness_of(const std::vector<Outcome>& outcomes) {
    double worst = std::numeric_limits<double>::infinity();
    for (const Outcome& outcome : outcomes) {
        if (!outcome.failed) worst = std::min(worst, outcome.score.mean);
    }
    if (worst == std::numeric_limits<double>::infinity()) worst = 0.0;
    std::vector<double> fitness;
    for (const Outcome& outcome : outcomes) {
        fitness.push_back(outcome.failed ? worst : outcome.score.mean);
    }
    return fitness;
}

double mean_links(const std::vector<Genome>& population) {
    double links = 0.0;
    for (const Genome& genome : population) links += static_cast<double>(genome.links.size());
    return links / static_cast<double>(population.size());
}

}  // namespace

Search::Search(const Settings& settings, const network::Definition& start, std::uint64_t seed)
    : settings_(settings),
      interface_(start),
      seed_(seed),
      innovations_(interface_.first_new_node()),
      best_fitness_(kNone) {
    const bool recurs = std::any_of(start.links.begin(), start.links.end(),
                                    [](const network::Link& l) { return l.recurrent; });
    if (recurs && !settings_.recurrent) {
        throw AlgorithmError("the start network has recurrent links, but neat.networks is feed_forward");
    }
    found();
}

/// The first generation: the start network's structure, weights drawn or varied.
void Search::found() {
    const Genome first = interface_.first_genome(innovations_);
    RandomStream stream(seed_, "first generation", "neat.found");
    Settings draw = settings_;
    draw.perturb = settings_.start_from_network ? 1.0 : 0.0;
    population_.assign(static_cast<std::size_t>(settings_.population), first);
    for (std::size_t i = 0; i < population_.size(); ++i) {
        if (settings_.start_from_network && i == 0) continue;  // as it was given
        mutate_weights(population_[i], draw, stream);
    }
    phase_.floor = mean_links(population_);
}

network::Definition Search::network(std::size_t candidate) const {
    return interface_.network(population_[candidate]);
}

void Search::turn_phase() {
    if (settings_.complexity_ceiling == 0) return;
    const double mean = mean_links(population_);
    if (!phase_.pruning) {
        phase_.floor = std::min(phase_.floor, mean);
        if (mean < phase_.floor + settings_.complexity_ceiling) return;
        phase_ = {true, phase_.floor, mean, generation_};
    } else if (mean < phase_.leanest) {
        phase_.leanest = mean;
        phase_.since = generation_;
    } else if (generation_ - phase_.since >= settings_.pruning_patience) {
        phase_ = {false, mean, 0.0, 0};
    }
}

void Search::update(const std::vector<Outcome>& outcomes) {
    K3D_ASSERT(outcomes.size() == population_.size());
    const std::vector<double> fitness = fitness_of(outcomes);
    RandomStream stream(seed_, fmt::format("generation {}", generation_), "neat.reproduce");
    const double best = *std::max_element(fitness.begin(), fitness.end());
    if (best > best_fitness_) {
        best_fitness_ = best;
        improved_ = generation_;
    }
    const double threshold = fitted_threshold(species_, population_, settings_);
    speciate(species_, next_species_, population_, fitness, threshold, generation_, settings_, stream);
    turn_phase();
    const int stalled = generation_ - improved_;
    const std::vector<int> children = allot(species_, fitness, generation_, stalled, settings_);
    // The two best species have had their chance; everybody gets time again.
    if (settings_.population_stagnation > 0 && stalled > settings_.population_stagnation) {
        improved_ = generation_;
    }
    describe(children, threshold);
    population_ = reproduce(species_, children, population_, fitness, innovations_, settings_,
                            phase_.pruning, stream);
}

/// What the log says of the generation that has just been told.
void Search::describe(const std::vector<int>& children, double threshold) {
    double hidden = 0.0;
    double links = 0.0;
    int largest = 0;
    for (const Genome& genome : population_) {
        hidden += genome.hidden();
        links += genome.enabled_links();
        largest = std::max(largest, genome.enabled_links());
    }
    nlohmann::json list = nlohmann::json::array();
    for (std::size_t i = 0; i < species_.size(); ++i) {
        list.push_back({{"id", species_[i].id},
                        {"size", species_[i].members.size()},
                        {"born", species_[i].born},
                        {"best", exact(species_[i].best_fitness)},
                        {"children", children[i]}});
    }
    const auto size = static_cast<double>(population_.size());
    report_ = {{"population", population_.size()},
               {"species", list},
               {"threshold", exact(threshold)},
               {"mean_hidden", hidden / size},
               {"mean_links", links / size},
               {"most_links", largest},
               {"innovations", innovations_.links()},
               {"phase", phase_.pruning ? "prune" : "grow"}};
}

nlohmann::json Search::save() const {
    nlohmann::json population = nlohmann::json::array();
    for (const Genome& genome : population_) population.push_back(neat::save(genome));
    nlohmann::json species = nlohmann::json::array();
    for (const Species& s : species_) species.push_back(neat::save(s));
    return {{"population", population},
            {"innovations", innovations_.save()},
            {"species", species},
            {"next_species", next_species_},
            {"generation", generation_},
            {"best_fitness", exact(best_fitness_)},
            {"improved", improved_},
            {"phase", {{"pruning", phase_.pruning},
                       {"floor", exact(phase_.floor)},
                       {"leanest", exact(phase_.leanest)},
                       {"since", phase_.since}}},
            {"report", report_}};
}

void Search::load(const Reader& reader) {
    constexpr int kMost = std::numeric_limits<int>::max() - 1;
    innovations_.load(reader["innovations"]);
    const auto read = [this](const Reader& entry) {
        Genome genome = read_genome(entry);
        if (const std::string wrong = interface_.mismatch(genome); !wrong.empty()) entry.fail(wrong);
        for (const LinkGene& link : genome.links) {
            if (!innovations_.knows(link)) {
                entry.fail(fmt::format("innovation {} is not the registry's", link.innovation));
            }
            if (link.recurrent && !settings_.recurrent) {
                entry.fail("has a recurrent link, but neat.networks is feed_forward");
            }
        }
        if (!genome.nodes.empty() && genome.nodes.back().id >= innovations_.next_node()) {
            entry.fail(fmt::format("node {} is not the registry's", genome.nodes.back().id));
        }
        return genome;
    };
    population_.clear();
    reader["population"].each([&](const Reader& entry) { population_.push_back(read(entry)); });
    if (static_cast<int>(population_.size()) != settings_.population) {
        reader["population"].fail(fmt::format("has {} genomes, the population is {}",
                                              population_.size(), settings_.population));
    }
    species_.clear();
    reader["species"].each([&](const Reader& entry) {
        species_.push_back(read_species(entry, population_.size()));
        read(entry["representative"]);
    });
    next_species_ = reader["next_species"].integer(0, kMost);
    generation_ = reader["generation"].integer(0, kMost);
    best_fitness_ = reader["best_fitness"].number();
    improved_ = reader["improved"].integer(0, kMost);
    const Reader phase = reader["phase"];
    phase_ = {phase["pruning"].flag(), phase["floor"].finite(), phase["leanest"].finite(),
              phase["since"].integer(0, kMost)};
    report_ = reader["report"].json();
    if (!report_.is_object()) reader["report"].fail("is not an object");
}

}  // namespace k3d::optimizer::algorithm::neat
