// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/generation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "optimizer/algorithm/search.h"

namespace k3d::optimizer::algorithm {
namespace {

nlohmann::json save_track(const Track& track) {
    return {{"wanted", track.wanted},
            {"score", track.score ? save(*track.score) : nlohmann::json()},
            {"failed", track.failed}};
}

Track read_track(const Reader& reader) {
    Track track;
    track.wanted = reader["wanted"].integer(0, kMaxEpisodes);
    track.failed = reader["failed"].flag();
    const Reader score = reader["score"];
    if (score.is_null()) return track;
    track.score = read_score(score);
    if (track.score->n > track.wanted) score.fail("covers more episodes than were wanted");
    return track;
}

}  // namespace

std::vector<Outcome> outcomes(const std::vector<Entry>& entries, Pool pool) {
    std::vector<Outcome> all;
    for (const Entry& entry : entries) {
        const Track& track = entry.track(pool);
        const bool known = !track.failed && track.score.has_value();
        all.push_back({!known, known ? *track.score : Score{}});
    }
    return all;
}

bool want(std::vector<Entry>& entries, const std::vector<std::size_t>& indices, Pool pool,
          int episodes) {
    bool more = false;
    for (const std::size_t index : indices) {
        Track& track = entries[index].track(pool);
        track.wanted = std::max(track.wanted, std::min(episodes, kMaxEpisodes));
        more = more || track.is_open();
    }
    return more;
}

void check_score(std::uint64_t candidate, const Score& score, int wanted) {
    const auto refuse = [candidate](const std::string& what) {
        throw AlgorithmError(fmt::format("result of candidate {}: {}", candidate, what));
    };
    if (!std::isfinite(score.mean)) refuse(fmt::format("mean {} is not finite", score.mean));
    if (!std::isfinite(score.se) || score.se < 0.0) {
        refuse(fmt::format("standard error {} is not a number of at least 0", score.se));
    }
    if (score.n < 1 || score.n > wanted) {
        refuse(fmt::format("covers {} episodes, wanted are 1 to {}", score.n, wanted));
    }
}

nlohmann::json save(const Entry& entry) {
    return {{"id", entry.id},
            {"payload", save(entry.payload)},
            {"train", save_track(entry.train)},
            {"validation", save_track(entry.validation)}};
}

Entry read_entry(const Reader& reader, const spec::Problem& problem) {
    return {reader["id"].unsigned_integer(), read_payload(reader["payload"], problem),
            read_track(reader["train"]), read_track(reader["validation"])};
}

}  // namespace k3d::optimizer::algorithm
