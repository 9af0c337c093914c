// SPDX-License-Identifier: BSD-3-Clause
// A keepaway job as the match that it is.
#pragma once

#include <string>

#include "optimizer/episode/job.h"
#include "optimizer/spec/match_spec.h"

namespace k3d::optimizer::episode {

/// Writes the candidate's network, if it has one, to a file in `folder`. Throws std::runtime_error
/// if it cannot be written.
spec::MatchSpec match_of(const Job& job, const std::string& folder);

/// The candidate's settings as path=value words, its network's file among them.
std::vector<std::string> settings_of(const Job& job, const std::string& folder);

}  // namespace k3d::optimizer::episode
