// SPDX-License-Identifier: BSD-3-Clause
// The algorithms behind Algorithm, each a value with the same few verbs, and what differs by kind.
// A search makes a generation (begin), is told how it fared (update), and draws all its random
// numbers from streams named by seed and generation: no generator has to be saved.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "optimizer/algorithm/algorithm.h"
#include "optimizer/algorithm/cmaes/search.h"
#include "optimizer/algorithm/cross_entropy/search.h"
#include "optimizer/algorithm/neat/search.h"
#include "optimizer/algorithm/random_search/search.h"

namespace k3d::optimizer::algorithm {

using Search =
    std::variant<cmaes::Search, cross_entropy::Search, random_search::Search, neat::Search>;

/// Throws AlgorithmError for an algorithm that does not fit the problem.
Search make_search(const spec::AlgorithmSpec& spec, const spec::Problem& problem,
                   std::uint64_t seed);

/// What the agent gets: values, or a network.
Payload payload_of(const Search& search, std::size_t candidate);
/// The algorithm's own estimate of the optimum, which no single lucky episode made: the mean of a
/// distribution. None for those that have no such thing.
std::optional<Payload> centre_of(const Search& search);
/// True if candidate 0 of the first generation is what the search starts from, unchanged.
bool begins_with_start(const Search& search);
/// Episodes per candidate at the start of a generation, and how many in all the ranks need.
int first_episodes(const Search& search, const spec::SamplingSpec& sampling);
int episodes_wanted(const Search& search, const std::vector<Outcome>& outcomes);

nlohmann::json save(const Payload& payload);
Payload read_payload(const Reader& reader, const spec::Problem& problem);
nlohmann::json save(const spec::Problem& problem);
spec::Problem read_problem(const Reader& reader);

}  // namespace k3d::optimizer::algorithm
