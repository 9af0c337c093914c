// SPDX-License-Identifier: BSD-3-Clause
// The table at the end of a run.
#pragma once

#include <string>

#include "optimizer/report/run.h"
#include "optimizer/spec/match_spec.h"

namespace k3d::optimizer::report {

/// Several lines, the last one ended. Depends on spec and results alone, not on wall time.
std::string table(const spec::MatchSpec& spec, const Run& run);

}  // namespace k3d::optimizer::report
