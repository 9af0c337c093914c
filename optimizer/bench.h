// SPDX-License-Identifier: BSD-3-Clause
// What learning costs: simulated seconds per core-second of whole episodes, by stage and stepper.
#pragma once

#include <cstdint>
#include <string>

namespace k3d::optimizer {

struct BenchSettings {
    int episodes = 5;         ///< of each stepper
    std::uint64_t seed = 1;   ///< of the first one, the next ones count up
    double limit_s = 30.0;    ///< simulated, of one episode
    int keepers = 3;
    int takers = 2;
};

/// Plays the episodes one after another, each with processes of its own, the steppers by turns, and
/// returns the table: medians over the episodes. CPU time is that of the server and all agents, from
/// start to end. Throws std::runtime_error when an episode gives no valid result.
std::string bench(const BenchSettings& settings);

}  // namespace k3d::optimizer
