// SPDX-License-Identifier: BSD-3-Clause
// Plays the rows of a table of test episodes, each into a ledger of its own, so that an interrupted
// table goes on where it was.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

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

/// Throws config::ConfigError if a program refuses the settings of the table or of one of its rows,
/// naming the row, or the file that its settings are from.
void check_settings(const spec::TableSpec& table);

/// Plays what is missing of a row in `folder`, `jobs` episodes at a time. False if the user wants to
/// stop. Throws LedgerError if the row was begun by another player or on another task, or has
/// episodes missing and was begun by another code version.
bool play_row(const spec::TableSpec& table, const spec::RowSpec& row, const RowPlayer& player,
              const std::string& folder, int jobs, backend::Wakeups& wakeups,
              report::RunProgress& progress);

/// Those rows of a table that have been begun, as far as they have been played; `folder_of` tells
/// where each is. One that cannot be read costs no other: it has no episodes, and its origin says
/// why. Since that belongs to the disk or to other code, it is of no version of its own.
std::vector<report::ComparedRow> read_rows(
    const spec::TableSpec& table,
    const std::function<std::string(const spec::RowSpec&)>& folder_of);
/// Of what read_rows() has returned.
bool is_unreadable(const report::ComparedRow& row);

}  // namespace k3d::optimizer
