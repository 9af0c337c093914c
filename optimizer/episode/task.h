// SPDX-License-Identifier: BSD-3-Clause
// One try of one episode: what is to be done, and how it ended.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "common/episode/result.h"

namespace k3d::optimizer::episode {

using Result = k3d::episode::Result;

struct Task {
    int index = 0;  ///< of the episode in its run, from 0
    std::uint64_t seed = 0;
    int attempt = 1;
};

/// Why a try gave no valid result.
struct Failure {
    std::string reason;            ///< one line
    std::optional<Result> result;  ///< the server's line all the same, e.g. agent_lost or diverged
    /// Set when another try would fail in the same way (bad flag, busy port): the exit code due.
    std::optional<int> hopeless;
    /// This machine could not start a program (it is missing here, or no further process or file is
    /// to be had), which says nothing of the episode.
    bool of_machine = false;
};

using Ending = tl::expected<Result, Failure>;

}  // namespace k3d::optimizer::episode
