// SPDX-License-Identifier: BSD-3-Clause
// Connections to the monitor port: who watches gets frames, who commands is a trainer.
//
// Trainers that never read cost nothing and keep their framing: a frame goes out whole or not at
// all, none is composed for them while an earlier one is unsent, and the first one after a gap is a
// full one (reference 1.8, 8.1).
//
// The barrier (paces that wait for agents): a trainer joins with its first `(syn)`. From then on
// each frame it is sent carries `(syn 1)` in its state part, and the simulation stands still until
// the trainer has answered with one `(syn)`. What it sends up to that `(syn)` acts in the very next
// cycle, what it sends behind it at the next turn; so its commands act in fixed cycles.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "common/log/limiter.h"
#include "common/net/net.h"
#include "common/wire/trainer.h"

namespace k3d::server::session {

/// Whether `network.trainers` lets this peer ("127.0.0.1:51234") command the simulation.
bool may_command(std::string_view trainers, std::string_view peer);

/// What a trainer wants, and which one does.
struct Order {
    std::string peer;
    wire::TrainerCommand command;
};

/// Makes frames on demand.
struct FrameSource {
    std::function<std::string()> full;
    std::function<std::string()> difference;  ///< to the one before; called once a turn at most
};

class Monitors {
  public:
    /// `barrier`: whether a `(syn)` makes the simulation wait. `on_left` hears who is dropped.
    explicit Monitors(bool barrier, std::function<void(int id)> on_left = {});

    void accept(std::unique_ptr<net::Connection> connection, int id, bool commands);

    /// Reads what has arrived, of a trainer in the barrier up to its `(syn)` of this turn. True if
    /// no trainer's `(syn)` is missing. Who has left is dropped.
    bool read();
    /// What was read since the last call, by connection in order of acceptance.
    std::vector<Order> take_commands();
    /// Gives up trainers whose `(syn)` is missing.
    void close_hung();

    /// Whether anybody would take a frame now.
    bool watched() const;
    /// The next frame of everybody must be a full one.
    void require_full();
    /// One frame for everybody; begins the barrier's next turn.
    void send(const FrameSource& source);
    /// A full frame for those outside the barrier that were told nothing yet or asked for it.
    void greet(const FrameSource& source);

  private:
    struct Monitor {
        int id = 0;
        std::unique_ptr<net::Connection> connection;
        bool commands = false;     ///< may command
        bool refused = false;      ///< and it was said that it may not
        bool needs_full = true;    ///< was told nothing yet, missed a frame or asked for a full one
        bool in_barrier = false;
        bool synced = false;       ///< its (syn) of this turn has come
        std::vector<wire::TrainerCommand> pending;
    };
    void take_frame(Monitor& monitor, std::string_view frame);
    void drop_left();

    log::Limiter notices_;
    bool barrier_;
    std::function<void(int)> on_left_;
    std::vector<Monitor> monitors_;
    std::vector<wire::TrainerCommand> scratch_;
};

}  // namespace k3d::server::session
