// SPDX-License-Identifier: BSD-3-Clause
// The paper's keepaway (section 2): a fixed square; it ends when a taker reaches the ball, or when the
// ball or a keeper leaves the square.
#pragma once

#include <optional>
#include <string>

#include "server/body/scene.h"
#include "server/game/keepaway/config.h"

namespace k3d::server::game {

/// Why the episode is over, by the truth after a step.
std::optional<std::string> broken_paper_rule(const KeepawayConfig& config, const body::Scene& scene);

}  // namespace k3d::server::game
