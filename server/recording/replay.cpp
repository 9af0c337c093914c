// SPDX-License-Identifier: BSD-3-Clause
#include "server/recording/replay.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

namespace k3d::server::recording {

namespace {

class ReplayedConnection final : public net::Connection {
  public:
    ReplayedConnection(std::string peer, std::deque<std::string>& inbox)
        : peer_(std::move(peer)), inbox_(inbox) {}

    bool next_frame(std::string_view& payload) override {
        if (inbox_.empty()) return false;
        frame_ = std::move(inbox_.front());
        inbox_.pop_front();
        payload = frame_;
        return true;
    }
    bool send(std::string_view) override { return false; }  // nobody listens
    bool ready() override { return false; }
    bool closed() const override { return closed_; }
    bool spent() const override { return closed_ && inbox_.empty(); }
    bool broke_limit() const override { return false; }
    const std::string& close_reason() const override { return reason_; }
    const std::string& peer() const override { return peer_; }
    void close(std::string_view reason) override {
        closed_ = true;
        reason_ = reason;
    }

  private:
    std::string peer_, reason_, frame_;
    std::deque<std::string>& inbox_;
    bool closed_ = false;
};

std::ifstream opened(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw RecordError(file + ": cannot read: " + std::strerror(errno));
    return in;
}

}  // namespace

Replay::Replay(const std::string& file)
    : file_(opened(file)), name_(file), reader_(file_, file) {}

std::optional<ReplayStep> Replay::next_step() {
    ReplayStep step;
    while (auto entry = reader_.next()) {
        if (complete_) throw RecordError(name_ + ": more behind the end of the run");
        if (const auto* end = std::get_if<StepEnd>(&*entry)) {
            step.digest = end->digest;
            return step;
        }
        if (auto* accepted = std::get_if<Accepted>(&*entry)) {
            const auto [inbox, is_new] = inboxes_.try_emplace(accepted->connection);
            if (!is_new) {
                throw RecordError(
                    fmt::format("{}: connection {} twice", name_, accepted->connection));
            }
            auto connection = std::make_unique<ReplayedConnection>(accepted->peer, inbox->second);
            step.arrivals.push_back({std::move(*accepted), std::move(connection)});
        } else if (auto* received = std::get_if<Received>(&*entry)) {
            const auto inbox = inboxes_.find(received->connection);
            if (inbox == inboxes_.end()) {
                throw RecordError(fmt::format("{}: a frame of connection {}, which never came",
                                              name_, received->connection));
            }
            inbox->second.push_back(std::move(received->frame));
        } else if (auto* left = std::get_if<Left>(&*entry)) {
            step.left.push_back(std::move(*left));
        } else {
            complete_ = true;
        }
    }
    return std::nullopt;
}

}  // namespace k3d::server::recording
