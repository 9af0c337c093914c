// SPDX-License-Identifier: BSD-3-Clause
#include "server/session/monitors.h"

#include "common/log/log.h"

namespace k3d::server::session {

Monitors::Monitors(net::Loop& loop, const std::string& address, std::uint16_t port)
    : listener_(loop, address, port, [this](std::unique_ptr<net::Connection> accepted) {
          spdlog::info("trainer at {} connected", accepted->peer());
          connections_.push_back(std::move(accepted));
      }) {}

const std::vector<wire::TrainerCommand>& Monitors::read() {
    commands_.clear();
    for (const auto& connection : connections_) {
        std::string_view frame;
        while (connection->next_frame(frame)) {
            if (const int bad = wire::decode(frame, commands_); bad > 0) {
                spdlog::warn("trainer at {}: {} unknown or damaged expressions ignored in \"{}\"",
                             connection->peer(), bad, frame.substr(0, 120));
            }
        }
    }
    std::erase_if(connections_, [](const auto& connection) {
        if (connection->closed()) {
            spdlog::info("trainer at {} left: {}", connection->peer(), connection->close_reason());
        }
        return connection->closed();
    });
    return commands_;
}

}  // namespace k3d::server::session
