// SPDX-License-Identifier: BSD-3-Clause
#include "server/recording/recorder.h"

#include <xxhash.h>

#include <array>
#include <bit>

namespace k3d::server::recording {

namespace {

class TappedConnection final : public net::Connection {
  public:
    TappedConnection(std::unique_ptr<net::Connection> inner, int number, RecordWriter& writer)
        : inner_(std::move(inner)), number_(number), writer_(writer) {}

    bool next_frame(std::string_view& payload) override {
        if (!inner_->next_frame(payload)) return false;
        writer_.add(number_, payload);
        return true;
    }
    bool send(std::string_view payload) override { return inner_->send(payload); }
    bool ready() override { return inner_->ready(); }
    void doze(std::chrono::milliseconds longest) override { inner_->doze(longest); }
    bool closed() const override { return inner_->closed(); }
    bool spent() const override { return inner_->spent(); }
    bool broke_limit() const override { return inner_->broke_limit(); }
    const std::string& close_reason() const override { return inner_->close_reason(); }
    const std::string& peer() const override { return inner_->peer(); }
    void close(std::string_view reason) override { inner_->close(reason); }

  private:
    std::unique_ptr<net::Connection> inner_;
    int number_;
    RecordWriter& writer_;
};

}  // namespace

std::uint64_t digest(std::uint64_t physics_hash, Cycle clock, const game::GameState& state) {
    const std::array<std::uint64_t, 7> words{physics_hash,
                                             static_cast<std::uint64_t>(clock.count),
                                             static_cast<std::uint64_t>(state.mode),
                                             std::bit_cast<std::uint64_t>(state.time),
                                             static_cast<std::uint64_t>(state.half),
                                             static_cast<std::uint64_t>(state.score_left),
                                             static_cast<std::uint64_t>(state.score_right)};
    return XXH3_64bits(words.data(), sizeof words);
}

std::unique_ptr<net::Connection> Recorder::tap(std::unique_ptr<net::Connection> connection,
                                               const Accepted& accepted) {
    writer_.add(accepted);
    return std::make_unique<TappedConnection>(std::move(connection), accepted.connection, writer_);
}

}  // namespace k3d::server::recording
