// SPDX-License-Identifier: BSD-3-Clause
// The match loop: tasks out, endings in, until the run is settled.
#pragma once

#include "optimizer/hopeless.h"
#include "optimizer/report/progress.h"
#include "optimizer/report/run.h"
#include "optimizer/spec/match_spec.h"

namespace k3d::optimizer {

/// Plays all episodes, or until SIGINT, SIGTERM or SIGHUP. Ends with no process left, whatever it
/// returns or throws. Throws HopelessRun, std::invalid_argument for a spec that cannot be, and
/// std::runtime_error for a file that cannot be written or a program that cannot be started.
report::Run play_match(const spec::MatchSpec& spec, report::Progress& progress);

}  // namespace k3d::optimizer
