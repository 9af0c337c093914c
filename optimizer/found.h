// SPDX-License-Identifier: BSD-3-Clause
// What a search has found so far, whether it is over or not, read from its ledger.
#pragma once

#include <optional>
#include <string>

#include "optimizer/algorithm/algorithm.h"
#include "optimizer/ledger/ledger.h"
#include "optimizer/spec/experiment.h"

namespace k3d::optimizer {

struct Found {
    spec::Experiment experiment;
    std::optional<algorithm::Champion> champion;
    std::string origin;  ///< of the champion: candidate, run, version, score
    std::string version;  ///< of the code that searched
    int generations = 0;
    bool finished = false;  ///< the search is over
};

/// Throws LedgerError if there is no such run.
Found found_in(const std::string& folder);

/// The algorithm as the ledger last saved it; none before the first generation is closed.
std::optional<algorithm::Algorithm> algorithm_in(const ledger::Ledger& ledger,
                                                 const std::string& folder);

}  // namespace k3d::optimizer
