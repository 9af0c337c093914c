// SPDX-License-Identifier: BSD-3-Clause
// The one interface of all algorithms: ask for episodes, tell their results, advance.
//
//     Algorithm algorithm(spec, problem, seed);
//     while (!algorithm.finished()) {
//         for (const Request& r : algorithm.ask())
//             algorithm.tell(r.candidate, r.pool, play(r));   // in any order, bit by bit
//         algorithm.advance();
//     }
//
// An Algorithm is a value: it knows no clock, thread or file. Its state follows from (spec, problem,
// seed) and the results told, not from the order in which they came. Fitness: larger is better.
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "common/network/network.h"
#include "optimizer/algorithm/error.h"
#include "optimizer/algorithm/score.h"
#include "optimizer/algorithm/seeds.h"
#include "optimizer/spec/algorithm_spec.h"

namespace k3d::optimizer::algorithm {

/// Parameter values in the order and units of the problem, or a network as the agent loads it.
using Payload = std::variant<std::vector<double>, network::Definition>;

/// Episodes that are wanted: those with index 0 .. episodes - 1 of this candidate in this pool.
/// A later request may name the same candidate and pool with more episodes; those played before
/// count, only the further ones are to be played. Episode i has the seed
/// scenario_seed(run seed, pool, generation, i): every candidate of a generation meets the same.
struct Request {
    std::uint64_t candidate = 0;  ///< unique in the run, in order of birth
    int generation = 0;           ///< from 0
    Pool pool = Pool::Train;
    int episodes = 1;
    Payload payload;
    bool operator==(const Request&) const = default;
};

/// The best candidate by re-evaluation; without noise (no validation) by its fitness.
struct Champion {
    std::uint64_t candidate = 0;
    int generation = 0;  ///< in which it was born
    Payload payload;
    Score score;  ///< on validation seeds if there is a validation
    bool validated = false;
    bool operator==(const Champion&) const = default;
};

class Algorithm {
  public:
    /// Throws AlgorithmError if a setting or the problem makes no sense.
    Algorithm(const spec::AlgorithmSpec& spec, const spec::Problem& problem, std::uint64_t seed);
    Algorithm(const Algorithm& other);
    Algorithm& operator=(const Algorithm& other);
    Algorithm(Algorithm&&) noexcept;
    Algorithm& operator=(Algorithm&&) noexcept;
    ~Algorithm();

    /// The requests not yet answered, by candidate and pool; the same until something is told.
    std::vector<Request> ask() const;
    /// `score` covers all episodes of this candidate in this pool so far; the request is answered
    /// once it covers the episodes wanted. Returns false, and does nothing, for a candidate that waits
    /// for nothing any more (a late or second copy). Throws AlgorithmError for a candidate never
    /// asked, for numbers that are not finite, for n below 1 or above what was asked.
    bool tell(std::uint64_t candidate, Pool pool, const Score& score);
    /// No result can be had: the candidate ranks behind all that have one.
    bool tell_failed(std::uint64_t candidate, Pool pool);

    /// True when every request is answered.
    bool settled() const;
    /// Closes the round: then further episodes of the same generation are wanted, or the next
    /// generation begins, or the run has finished. Throws std::logic_error unless settled().
    void advance();

    /// The generation under evaluation is the last one; its best are validated as at any end. Not part
    /// of the saved state: said again after restore().
    void end_after_generation(const std::string& reason);

    /// Why the search is over; then ask() is empty. Says "max_generations", "target", ...
    std::optional<std::string> finished() const;
    int generation() const;               ///< the one that is being evaluated
    std::uint64_t episodes_told() const;  ///< n of all answered requests, each episode once
    std::optional<Champion> champion() const;
    /// Hall of fame: the champions so far, the present one last; the oldest fall out beyond kMostFame.
    const std::vector<Champion>& hall_of_fame() const;
    static constexpr std::size_t kMostFame = 50;
    /// One line for each generation closed since the last call: "generation", "candidates", "best",
    /// "median", "mean" (fitness) and what the algorithm adds ("sigma", "species", ...).
    std::vector<nlohmann::json> take_log();

    /// The whole state, version "format"/"version"; restore() continues with the same bits.
    nlohmann::json save() const;
    /// Throws AlgorithmError naming `source` and the place.
    static Algorithm restore(const nlohmann::json& state, std::string_view source);
    static Algorithm restore_text(std::string_view json, std::string_view source);

  private:
    struct Impl;
    explicit Algorithm(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace k3d::optimizer::algorithm
