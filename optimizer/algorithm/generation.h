// SPDX-License-Identifier: BSD-3-Clause
// The candidates of the generation under evaluation: what is wanted of each and what has been told.
#pragma once

#include <optional>
#include <vector>

#include "optimizer/algorithm/algorithm.h"

namespace k3d::optimizer::algorithm {

/// One candidate in one pool.
struct Track {
    int wanted = 0;              ///< episodes in all
    std::optional<Score> score;  ///< over score->n of them
    bool failed = false;

    bool is_open() const { return wanted > 0 && !failed && (!score || score->n < wanted); }
    bool operator==(const Track&) const = default;
};

struct Entry {
    std::uint64_t id = 0;
    Payload payload;
    Track train;
    Track validation;

    Track& track(Pool pool) { return pool == Pool::Validation ? validation : train; }
    const Track& track(Pool pool) const { return pool == Pool::Validation ? validation : train; }
};

/// What is known per candidate in one pool; a candidate without a score counts as failed.
std::vector<Outcome> outcomes(const std::vector<Entry>& entries, Pool pool);

/// Wants at least `episodes` in all of the candidates at these indices. That is noted of one that
/// failed too, but it is asked for no more of them. True if any of the others has episodes to play.
bool want(std::vector<Entry>& entries, const std::vector<std::size_t>& indices, Pool pool,
          int episodes);

/// Checks a score that is told; throws AlgorithmError naming the candidate and the value.
void check_score(std::uint64_t candidate, const Score& score, int wanted);

nlohmann::json save(const Entry& entry);
Entry read_entry(const Reader& reader, const spec::Problem& problem);

}  // namespace k3d::optimizer::algorithm
