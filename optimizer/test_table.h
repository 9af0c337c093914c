// SPDX-License-Identifier: BSD-3-Clause
// Plays the rows of a table of test episodes, each into a ledger of its own, so that an interrupted
// table goes on where it was.
#pragma once

#include <optional>
#include <string>

#include "optimizer/backend/wakeups.h"
#include "optimizer/found.h"
#include "optimizer/report/comparison.h"
#include "optimizer/report/run_progress.h"
#include "optimizer/spec/reproduction.h"

namespace k3d::optimizer {

/// Who plays a row: what was found, or the row's own settings.
struct RowPlayer {
    std::optional<Found> found;
    std::string who;  ///< one line; a row that was begun by another one is not gone on with
};

/// Plays what is missing of a row in `folder`, `jobs` episodes at a time. False if the user wants to
/// stop. Throws LedgerError if the row was begun by another player or on another task, or has
/// episodes missing and was begun by another code version.
bool play_row(const spec::TableSpec& table, const spec::RowSpec& row, const RowPlayer& player,
              const std::string& folder, int jobs, backend::Wakeups& wakeups,
              report::RunProgress& progress);

/// The row as far as it has been played; without episodes if it has not been begun.
report::ComparedRow read_row(const spec::RowSpec& row, const std::string& folder);

}  // namespace k3d::optimizer
