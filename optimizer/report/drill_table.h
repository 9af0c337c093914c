// SPDX-License-Identifier: BSD-3-Clause
// The table at the end of a drill: each metric over the runs that have it.
#pragma once

#include <string>
#include <vector>

#include "common/episode/result.h"
#include "optimizer/spec/drill_spec.h"

namespace k3d::optimizer::report {

/// Several lines, the last one ended. Depends on spec and results alone, not on wall time.
std::string drill_table(const spec::DrillSpec& spec,
                        const std::vector<k3d::episode::Result>& results);

}  // namespace k3d::optimizer::report
