// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/search.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace k3d::optimizer::algorithm {
namespace {

constexpr double kMostNumbers = 4e6;  // of one generation: 32 MB

template <class... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

Coordinates coordinates_of(const spec::AlgorithmSpec& spec, const spec::Problem& problem) {
    const auto* parameters = std::get_if<spec::VectorProblem>(&problem);
    if (parameters == nullptr) {
        throw AlgorithmError(
            fmt::format("algorithm \"{}\" searches a list of parameters, not a network", spec.name));
    }
    return Coordinates(*parameters);
}

void check_size(int population, const Coordinates& space) {
    if (static_cast<double>(population) * space.dimension() > kMostNumbers) {
        throw AlgorithmError(fmt::format("a population of {} with {} parameters is too large",
                                         population, space.dimension()));
    }
}

}  // namespace

Search make_search(const spec::AlgorithmSpec& spec, const spec::Problem& problem,
                   std::uint64_t seed) {
    const auto* sought = std::get_if<spec::NetworkProblem>(&problem);
    if (sought != nullptr) {
        try {
            network::Network(sought->start, "start network");
        } catch (const network::NetworkError& error) {
            throw AlgorithmError(error.what());
        }
    }
    if (spec.name == "neat") {
        if (sought == nullptr) {
            throw AlgorithmError("algorithm \"neat\" searches a network, not a list of parameters");
        }
        return neat::Search(neat::settings_of(spec.neat), sought->start, seed);
    }
    Coordinates space = coordinates_of(spec, problem);
    if (spec.name == "cmaes") {
        const double budget = spec.max_episodes > 0.0
                                  ? spec.max_episodes / spec.sampling.episodes
                                  : std::numeric_limits<double>::infinity();
        return cmaes::Search(spec, std::move(space), seed, budget);
    }
    if (spec.name == "cross_entropy") {
        check_size(spec.cross_entropy.population, space);
        return cross_entropy::Search(spec.cross_entropy, std::move(space), seed);
    }
    check_size(spec.random_search.population, space);
    return random_search::Search(spec.random_search, std::move(space), seed);
}

Payload payload_of(const Search& search, std::size_t candidate) {
    return std::visit(
        Overloaded{[&](const neat::Search& s) { return Payload(s.network(candidate)); },
                   [&](const auto& s) { return Payload(s.values(candidate)); }},
        search);
}

std::optional<Payload> centre_of(const Search& search) {
    using Centre = std::optional<Payload>;
    return std::visit(Overloaded{[](const neat::Search&) { return Centre(); },
                                 [](const random_search::Search&) { return Centre(); },
                                 [](const auto& s) { return Centre(s.centre()); }},
                      search);
}

bool begins_with_start(const Search& search) {
    const auto* neat = std::get_if<neat::Search>(&search);
    return neat != nullptr && neat->begins_with_start();
}

int first_episodes(const Search& search, const spec::SamplingSpec& sampling) {
    const auto* cmaes = std::get_if<cmaes::Search>(&search);
    return cmaes != nullptr ? cmaes->episodes() : sampling.episodes;
}

int episodes_wanted(const Search& search, const std::vector<Outcome>& outcomes) {
    const auto* cmaes = std::get_if<cmaes::Search>(&search);
    return cmaes != nullptr ? cmaes->episodes_wanted(outcomes) : 0;
}

nlohmann::json save(const Payload& payload) {
    return std::visit(
        Overloaded{[](const std::vector<double>& values) { return exact(values); },
                   [](const network::Definition& network) { return network_json(network); }},
        payload);
}

Payload read_payload(const Reader& reader, const spec::Problem& problem) {
    if (const auto* parameters = std::get_if<spec::VectorProblem>(&problem)) {
        return reader.finite_list(parameters->size());
    }
    return read_network(reader);
}

nlohmann::json save(const spec::Problem& problem) {
    if (const auto* sought = std::get_if<spec::NetworkProblem>(&problem)) {
        return {{"network", network_json(sought->start)}};
    }
    nlohmann::json list = nlohmann::json::array();
    for (const spec::Parameter& p : std::get<spec::VectorProblem>(problem)) {
        list.push_back({{"name", p.name},
                        {"start", exact(p.start)},
                        {"deviation", exact(p.deviation)},
                        {"lower", exact(p.lower)},
                        {"upper", exact(p.upper)},
                        {"integer", p.integer},
                        {"frozen", p.frozen}});
    }
    return {{"parameters", list}};
}

spec::Problem read_problem(const Reader& reader) {
    if (reader.has("network")) return spec::NetworkProblem{read_network(reader["network"])};
    spec::VectorProblem parameters;
    reader["parameters"].each([&parameters](const Reader& entry) {
        parameters.push_back({entry["name"].text(), entry["start"].number(),
                              entry["deviation"].number(), entry["lower"].number(),
                              entry["upper"].number(), entry["integer"].flag(),
                              entry["frozen"].flag()});
    });
    return parameters;
}

}  // namespace k3d::optimizer::algorithm
