// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/found.h"

#include "optimizer/report/run_report.h"
#include "optimizer/run.h"

namespace k3d::optimizer {

std::optional<algorithm::Algorithm> algorithm_in(const ledger::Ledger& ledger,
                                                 const std::string& folder) {
    const auto round = ledger.last_round();
    if (!round) return std::nullopt;
    return algorithm::Algorithm::restore_text(round->state, ledger_file(folder));
}

Found found_in(const std::string& folder) {
    const auto ledger = ledger::Ledger::open(ledger_file(folder), ledger::Ledger::Access::Read);
    const ledger::Facts facts = ledger.facts();
    Found found;
    found.experiment = experiment_of(facts);
    found.version = facts.at("code_version");
    found.finished = facts.contains("searched");
    if (const auto algorithm = algorithm_in(ledger, folder)) {
        found.champion = algorithm->champion();
        found.generations = static_cast<int>(ledger.log().size());
    }
    if (found.champion) found.origin = report::origin_of(*found.champion, facts);
    return found;
}

}  // namespace k3d::optimizer
