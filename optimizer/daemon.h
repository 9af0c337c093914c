// SPDX-License-Identifier: BSD-3-Clause
// The optimiser's loop: what the algorithm wants to know out, episodes in, until the run is over.
#pragma once

#include "optimizer/backend/backend.h"
#include "optimizer/backend/wakeups.h"
#include "optimizer/run.h"
#include "optimizer/watch.h"

namespace k3d::optimizer {

enum class Ended { Done, Stopped };

/// Goes on with the run to its end, or until SIGINT, SIGTERM or SIGHUP; then it can be resumed.
/// Throws HopelessRun, LedgerError, and what the backend throws; the ledger is whole all the same.
Ended optimise(Run& run, backend::Backend& backend, backend::Wakeups& wakeups,
               Watch& watch);

}  // namespace k3d::optimizer
