// SPDX-License-Identifier: BSD-3-Clause
// One run of a drill, from start to EpisodeResult.
#pragma once

#include <string>

#include "common/episode/result.h"
#include "optimizer/drill/stage.h"
#include "optimizer/spec/drill_spec.h"

namespace k3d::optimizer::drill {

/// Run `index`, counted from 0, with seed spec.seed + index; all files go to `folder`. The result's
/// game is "drill_" and the drill's name, its hold time the simulated time. Throws Stopped,
/// DrillFailure, SceneError, episode::TelemetryError, process::ProcessError and net::NetError; no
/// process is left then.
k3d::episode::Result play(const spec::DrillSpec& spec, int index, const std::string& folder,
                          int http_port, const Listener& listener);

}  // namespace k3d::optimizer::drill
