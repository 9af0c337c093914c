// SPDX-License-Identifier: BSD-3-Clause
// Connections to the monitor port: trainers that write commands and need not read.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/net/net.h"
#include "common/wire/trainer.h"

namespace k3d::server::session {

class Monitors {
  public:
    Monitors(net::Loop& loop, const std::string& address, std::uint16_t port);

    std::uint16_t port() const { return listener_.port(); }
    /// All commands that have arrived, by connection in order of acceptance.
    const std::vector<wire::TrainerCommand>& read();

  private:
    std::vector<std::unique_ptr<net::Connection>> connections_;
    std::vector<wire::TrainerCommand> commands_;
    net::Listener listener_;
};

}  // namespace k3d::server::session
