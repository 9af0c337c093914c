// SPDX-License-Identifier: BSD-3-Clause
// What has come of a run so far.
#pragma once

#include <cstddef>
#include <map>

#include "optimizer/episode/task.h"

namespace k3d::optimizer::report {

/// Both by the episode's index: the order in which episodes end must not show in a sum.
struct Run {
    std::map<int, episode::Result> results;
    std::map<int, episode::Failure> failures;  ///< of the last try
    bool interrupted = false;

    std::size_t settled() const { return results.size() + failures.size(); }
};

}  // namespace k3d::optimizer::report
