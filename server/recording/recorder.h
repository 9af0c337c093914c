// SPDX-License-Identifier: BSD-3-Clause
// Listens in on a run's connections and writes down what the simulation takes from them.
#pragma once

#include <memory>
#include <string>

#include "common/clock/clock.h"
#include "common/net/net.h"
#include "server/game/state.h"
#include "server/recording/record_writer.h"

namespace k3d::server::recording {

/// What must be the same when a recording is played: physics, clock and game.
std::uint64_t digest(std::uint64_t physics_hash, Cycle clock, const game::GameState& state);

class Recorder {
  public:
    /// Throws std::runtime_error if the file cannot be written.
    Recorder(const std::string& file, const Header& header) : writer_(file, header) {}

    /// The connection, each of whose frames is recorded when it is taken. The recorder must outlive
    /// it.
    std::unique_ptr<net::Connection> tap(std::unique_ptr<net::Connection> connection,
                                         const Accepted& accepted);
    void left(int connection, const std::string& why) { writer_.add(Left{connection, why}); }
    void end_step(std::uint64_t state) { writer_.add(StepEnd{state}); }
    void end(int outcome) { writer_.add(End{outcome}); }

  private:
    RecordWriter writer_;
};

}  // namespace k3d::server::recording
