// SPDX-License-Identifier: BSD-3-Clause
// The plots of a run's report.
#pragma once

#include <string>
#include <vector>

#include "optimizer/ledger/row.h"
#include "optimizer/report/curves.h"

namespace k3d::optimizer::report {

/// SVG figures: fitness, test, species and complexity if there are any, parameters. `measure` names
/// the fitness.
std::string plots(const Curves& curves, const std::vector<ledger::Row>& rows,
                  const std::string& measure);

}  // namespace k3d::optimizer::report
