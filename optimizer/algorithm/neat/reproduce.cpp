// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/neat/reproduce.h"

#include <algorithm>
#include <cmath>

#include "common/log/log.h"
#include "optimizer/algorithm/neat/crossover.h"
#include "optimizer/algorithm/neat/mutate.h"

namespace k3d::optimizer::algorithm::neat {
namespace {

struct Nursery {
    const std::vector<Species>& species;
    const std::vector<Genome>& population;
    const std::vector<double>& fitness;
    Innovations& innovations;
    const Settings& settings;
    bool pruning;
    RandomStream& stream;

    std::size_t any_of(const std::vector<std::size_t>& members, std::size_t count) const {
        return members[static_cast<std::size_t>(stream.below(static_cast<int>(count)))];
    }

    /// The best members of a species, those that may be parents.
    std::size_t parents_of(const Species& s) const {
        const auto size = static_cast<double>(s.members.size());
        return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(settings.survival * size)));
    }

    /// Between equals the smaller genome counts as the fitter.
    Genome cross_of(std::size_t a, std::size_t b) const {
        const bool a_first =
            fitness[a] != fitness[b] ? fitness[a] > fitness[b]
                                     : population[a].links.size() <= population[b].links.size();
        return a_first ? cross(population[a], population[b], settings, stream)
                       : cross(population[b], population[a], settings, stream);
    }

    Genome child_of(const Species& s) const {
        const std::size_t parents = parents_of(s);
        const std::size_t first = any_of(s.members, parents);
        // Crossing would bring back what pruning removed.
        const bool alone = pruning || stream.uniform() < settings.mutate_only;
        if (!alone && species.size() > 1 && stream.uniform() < settings.interspecies) {
            const auto other = stream.below(static_cast<int>(species.size()));
            const Species& mate = species[static_cast<std::size_t>(other)];
            Genome child = cross_of(first, any_of(mate.members, parents_of(mate)));
            mutate(child, innovations, settings, pruning, stream);
            return child;
        }
        if (alone || parents < 2) {
            Genome child = population[first];
            mutate(child, innovations, settings, pruning, stream);
            return child;
        }
        Genome child = cross_of(first, any_of(s.members, parents));
        if (stream.uniform() >= settings.mate_only) {
            mutate(child, innovations, settings, pruning, stream);
        }
        return child;
    }
};

}  // namespace

std::vector<Genome> reproduce(const std::vector<Species>& species, const std::vector<int>& children,
                              const std::vector<Genome>& population,
                              const std::vector<double>& fitness, Innovations& innovations,
                              const Settings& settings, bool pruning, RandomStream& stream) {
    const Nursery nursery{species, population, fitness, innovations, settings, pruning, stream};
    std::vector<Genome> next;
    for (std::size_t i = 0; i < species.size(); ++i) {
        int wanted = children[i];
        if (wanted > 0 && static_cast<int>(species[i].members.size()) > settings.elitism_size) {
            next.push_back(population[species[i].members.front()]);
            --wanted;
        }
        for (; wanted > 0; --wanted) next.push_back(nursery.child_of(species[i]));
    }
    K3D_ASSERT(static_cast<int>(next.size()) == settings.population);
    return next;
}

}  // namespace k3d::optimizer::algorithm::neat
