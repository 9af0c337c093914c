// SPDX-License-Identifier: BSD-3-Clause
// What only the agents know of an episode, from their telemetry: JSON lines stamped with the
// server's `time`, of which those with an `event` tell a decision, e.g.
//     {"time": 12.34, "event": "kick_attempt", ...}
#pragma once

#include <stdexcept>
#include <string>

namespace k3d::optimizer::episode {

/// Names file and line.
class TelemetryError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Kick motions begun by this agent. Throws TelemetryError for a missing file, or a line that is
/// not an object with a numeric time; a last line without its newline counts as such a line.
int count_attempts(const std::string& file);

}  // namespace k3d::optimizer::episode
