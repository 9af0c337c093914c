// SPDX-License-Identifier: BSD-3-Clause
// The optimizer's loop: tasks out, endings in, until the run is settled.
#pragma once

#include <stdexcept>
#include <string>

#include "optimizer/report/progress.h"
#include "optimizer/report/run.h"
#include "optimizer/spec/match_spec.h"

namespace k3d::optimizer {

/// No episode of this run can be played; the text is one line.
class HopelessRun : public std::runtime_error {
  public:
    HopelessRun(const std::string& what, int code) : std::runtime_error(what), exit_code(code) {}
    int exit_code;
};

/// Plays all episodes, or until SIGINT, SIGTERM or SIGHUP. Ends with no process left, whatever it
/// returns or throws. Throws HopelessRun, std::invalid_argument for a spec that cannot be, and
/// std::runtime_error for a file that cannot be written or a program that cannot be started.
report::Run play_match(const spec::MatchSpec& spec, report::Progress& progress);

}  // namespace k3d::optimizer
