// SPDX-License-Identifier: BSD-3-Clause
#include "server/session/monitors.h"

#include <algorithm>

#include "common/log/log.h"

namespace k3d::server::session {

namespace {

/// The frame as a trainer in the barrier gets it: to be answered.
std::string with_syn(const std::string& frame) {
    std::string text = frame;
    std::size_t end_of_state = text.find(")(RDS 0 1)(");
    if (end_of_state == std::string::npos) end_of_state = text.find(")(RSG 0 1)(");
    K3D_ASSERT(end_of_state != std::string::npos);
    return text.insert(end_of_state, "(syn 1)");
}

}  // namespace

bool may_command(std::string_view trainers, std::string_view peer) {
    if (trainers == "loopback") {
        // A listener for both families tells of an IPv4 peer as the IPv6 address it is mapped to.
        return peer.starts_with("127.") || peer.starts_with("[::1]") ||
               peer.starts_with("[::ffff:127.");
    }
    return trainers == "all";
}

Monitors::Monitors(bool barrier, std::function<void(int)> on_left)
    : barrier_(barrier), on_left_(std::move(on_left)) {}

void Monitors::accept(std::unique_ptr<net::Connection> connection, int id, bool commands) {
    drop_left();  // strangers may come and go by the thousand while a cycle waits
    notices_.say(spdlog::level::info, "monitor at {} connected", connection->peer());
    Monitor& monitor = monitors_.emplace_back();
    monitor.id = id;
    monitor.connection = std::move(connection);
    monitor.commands = commands;
}

bool Monitors::read() {
    bool everybody = true;
    for (Monitor& monitor : monitors_) {
        std::string_view frame;
        while (!monitor.synced && monitor.connection->next_frame(frame)) take_frame(monitor, frame);
        const bool waited_for = monitor.in_barrier && !monitor.connection->closed();
        everybody = everybody && (!waited_for || monitor.synced);
    }
    drop_left();
    return everybody;
}

void Monitors::take_frame(Monitor& monitor, std::string_view frame) {
    scratch_.clear();
    if (const int bad = wire::decode(frame, scratch_); bad > 0) {
        notices_.say(spdlog::level::warn,
                     "trainer at {}: {} unknown or damaged expressions ignored in \"{}\"",
                     monitor.connection->peer(), bad, log::printable(frame));
    }
    for (wire::TrainerCommand& command : scratch_) {
        if (std::holds_alternative<wire::FullStateCommand>(command)) {
            monitor.needs_full = true;
        } else if (std::holds_alternative<wire::IdleCommand>(command)) {
            continue;
        } else if (!monitor.commands) {
            if (!monitor.refused) {
                notices_.say(spdlog::level::warn, "monitor at {} may not command: \"{}\" ignored",
                             monitor.connection->peer(), log::printable(frame));
            }
            monitor.refused = true;
        } else if (std::holds_alternative<wire::TrainerSynCommand>(command)) {
            if (barrier_ && !monitor.in_barrier) {
                notices_.say(spdlog::level::info, "trainer at {} is waited for",
                             monitor.connection->peer());
            }
            monitor.in_barrier = monitor.in_barrier || barrier_;
            monitor.synced = monitor.in_barrier;
        } else {
            monitor.pending.push_back(std::move(command));
        }
    }
}

void Monitors::drop_left() {
    std::erase_if(monitors_, [this](const Monitor& monitor) {
        // Frames of later turns may still be unread.
        const bool left = monitor.connection->spent() && !monitor.synced && monitor.pending.empty();
        if (left) {
            notices_.say(
                monitor.connection->broke_limit() ? spdlog::level::warn : spdlog::level::info,
                "monitor at {} left: {}", monitor.connection->peer(),
                monitor.connection->close_reason());
            if (on_left_) on_left_(monitor.id);
        }
        return left;
    });
}

std::vector<Order> Monitors::take_commands() {
    std::vector<Order> all;
    for (Monitor& monitor : monitors_) {
        for (wire::TrainerCommand& command : monitor.pending) {
            all.push_back({monitor.connection->peer(), std::move(command)});
        }
        monitor.pending.clear();
    }
    return all;
}

void Monitors::close_hung() {
    for (Monitor& monitor : monitors_) {
        if (!monitor.in_barrier || monitor.synced) continue;
        spdlog::warn("trainer at {} hangs: its (syn) is missing", monitor.connection->peer());
        monitor.connection->close("hung");
    }
}

bool Monitors::watched() const {
    return std::ranges::any_of(monitors_,
                               [](const Monitor& monitor) { return monitor.connection->ready(); });
}

void Monitors::require_full() {
    for (Monitor& monitor : monitors_) monitor.needs_full = true;
}

void Monitors::send(const FrameSource& source) {
    std::string full, difference;  // each made once, and only if somebody takes it
    for (Monitor& monitor : monitors_) {
        monitor.synced = false;
        if (!monitor.connection->ready()) {
            monitor.needs_full = true;
            continue;
        }
        std::string& text = monitor.needs_full ? full : difference;
        if (text.empty()) text = monitor.needs_full ? source.full() : source.difference();
        monitor.needs_full =
            !monitor.connection->send(monitor.in_barrier ? with_syn(text) : text);
    }
}

void Monitors::greet(const FrameSource& source) {
    std::string full;
    for (Monitor& monitor : monitors_) {
        if (!monitor.needs_full || monitor.in_barrier || !monitor.connection->ready()) continue;
        if (full.empty()) full = source.full();
        monitor.needs_full = !monitor.connection->send(full);
    }
}

}  // namespace k3d::server::session
