// SPDX-License-Identifier: BSD-3-Clause
// One run of a drill, from start to EpisodeResult.
#pragma once

#include <functional>
#include <string>

#include "common/episode/result.h"
#include "optimizer/spec/drill_spec.h"

namespace k3d::optimizer::drill {

/// Run `index`, counted from 0, with seed spec.seed + index; all files go to `folder`. `page`
/// hears the page's port once there is one. The result's game is "drill_" and the drill's name,
/// its hold time the simulated time. Throws DrillFailure, SceneError, episode::TelemetryError,
/// process::ProcessError and net::NetError; no process is left then.
k3d::episode::Result play(const spec::DrillSpec& spec, int index, const std::string& folder,
                          int http_port, const std::function<void(int)>& page);

}  // namespace k3d::optimizer::drill
