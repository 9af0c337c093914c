// SPDX-License-Identifier: BSD-3-Clause
// What the ledger keeps of an episode.
#pragma once

#include <cstdint>
#include <string>

#include "optimizer/episode/job.h"

namespace k3d::optimizer::ledger {

/// The first part follows from experiment and seed alone; the second from who played it when.
struct Row {
    episode::Key key;
    std::uint64_t seed = 0;
    std::string fingerprint;  ///< of the job: candidate, task and code
    std::string status;       ///< finished, truncated, or failed: no valid result in all its tries
    std::string reason;
    double fitness = 0.0;     ///< failed: the experiment's worst
    double simulated_s = 0.0;
    std::string result;       ///< the EpisodeResult's line; failed: empty

    int attempt = 1;
    double wall_s = 0.0;
    std::string worker;

    bool same_result(const Row& other) const {
        return key == other.key && seed == other.seed && fingerprint == other.fingerprint &&
               status == other.status && result == other.result;
    }
};

/// A try that gave no valid result.
struct FailedTry {
    episode::Key key;
    int attempt = 1;
    std::string reason;
    std::string worker;
};

}  // namespace k3d::optimizer::ledger
