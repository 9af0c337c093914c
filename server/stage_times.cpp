// SPDX-License-Identifier: BSD-3-Clause
// Simulation: what its cycles cost, for who asked by `stage_times`.
#include <fmt/format.h>

#include "server/cycle.h"

namespace k3d::server {

void Simulation::write_stage_times() {
    if (!stage_times_) return;
    stages_.enter(Stage::Shown);  // ends the stage before
    std::string line = fmt::format("{{\"cycles\":{}", cycles_measured_);
    for (std::size_t k = 0; k < kStageNames.size(); ++k) {
        line += fmt::format(",\"{}_s\":{:.6f}", kStageNames[k],
                            stages_.spent(static_cast<Stage>(k)));
    }
    line += fmt::format(",\"process_s\":{:.6f}}}\n", StageClock::process_seconds());
    stage_times_->write(line);
}

}  // namespace k3d::server
