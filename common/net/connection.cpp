// SPDX-License-Identifier: BSD-3-Clause
#include "common/net/connection.h"

#include <array>

#include "common/wire/frame.h"

namespace k3d::net {

namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

/// Socket and buffers. Handlers hold it, so it outlives the Connection until the last has run.
class Stream : public std::enable_shared_from_this<Stream> {
  public:
    explicit Stream(tcp::socket socket) : socket_(std::move(socket)) {
        error_code ignored;
        peer_ = text_of(socket_.remote_endpoint(ignored));
    }

    void start() {
        error_code fault;
        socket_.non_blocking(true, fault);
        if (!fault) socket_.set_option(tcp::no_delay(true), fault);
        if (fault) return close(fault.message());
        await_input();
    }

    bool next_frame(std::string_view& payload) {
        const auto status = reader_.next(payload);
        if (status == wire::FrameReader::Status::TooLong) {
            close("frame of " + std::to_string(reader_.announced_length()) +
                  " bytes announced, limit " + std::to_string(reader_.max_payload()));
            return false;
        }
        // Room again: go on where the buffer's limit stopped the reading.
        if (!awaiting_input_) await_input();
        return status == wire::FrameReader::Status::Frame;
    }

    bool send(std::string_view payload) {
        if (closed_) return false;
        if (!flush_tail()) return false;
        const auto length = static_cast<std::uint32_t>(payload.size());
        const std::array<unsigned char, wire::kPrefixBytes> prefix{
            static_cast<unsigned char>(length >> 24), static_cast<unsigned char>(length >> 16),
            static_cast<unsigned char>(length >> 8), static_cast<unsigned char>(length)};
        const std::array<asio::const_buffer, 2> parts{asio::buffer(prefix),
                                                      asio::buffer(payload.data(), payload.size())};
        error_code fault;
        const std::size_t sent = socket_.write_some(parts, fault);
        if (fault == asio::error::would_block) return false;  // nothing of it is out: drop it whole
        if (fault) {
            fail(fault);
            return false;
        }
        if (sent < prefix.size() + payload.size()) keep_tail(prefix, payload, sent);
        return true;
    }

    bool ready() { return !closed_ && flush_tail(); }

    void close(std::string_view reason) {
        if (closed_) return;
        closed_ = true;
        reason_ = reason;
        error_code ignored;
        socket_.shutdown(tcp::socket::shutdown_both, ignored);
        socket_.close(ignored);
    }

    bool closed() const { return closed_; }
    const std::string& reason() const { return reason_; }
    const std::string& peer() const { return peer_; }

  private:
    bool full() const { return reader_.buffered() >= Connection::kMaxBufferedIn; }

    void await_input() {
        if (closed_ || full()) return;
        awaiting_input_ = true;
        socket_.async_wait(tcp::socket::wait_read, [self = shared_from_this()](error_code fault) {
            self->awaiting_input_ = false;
            if (fault) return self->fail(fault);
            self->read_available();
            self->await_input();
        });
    }

    /// Reads what is there, up to the limit. Closes at the stream's end.
    void read_available() {
        std::array<char, 16 * 1024> bytes;
        while (!closed_ && !full()) {
            error_code fault;
            const std::size_t count = socket_.read_some(asio::buffer(bytes), fault);
            if (fault == asio::error::would_block) return;
            if (fault == asio::error::eof) return close("peer closed");
            if (fault) return close(fault.message());
            reader_.append({bytes.data(), count});
            if (count < bytes.size()) return;
        }
    }

    /// The peer may have sent its last frames before the fault: `(killsim)`, then away.
    void fail(error_code fault) {
        if (closed_) return;
        read_available();
        close(fault.message());
    }

    void keep_tail(const std::array<unsigned char, wire::kPrefixBytes>& prefix,
                   std::string_view payload, std::size_t sent) {
        tail_.assign(prefix.begin(), prefix.end());
        tail_.append(payload);
        tail_.erase(0, sent);
        await_output();
    }

    /// True if nothing is left of the earlier frame.
    bool flush_tail() {
        if (tail_.empty()) return true;
        error_code fault;
        const std::size_t sent = socket_.write_some(asio::buffer(tail_), fault);
        if (fault == asio::error::would_block) return false;
        if (fault) {
            fail(fault);
            return false;
        }
        tail_.erase(0, sent);
        return tail_.empty();
    }

    void await_output() {
        if (closed_ || awaiting_output_) return;
        awaiting_output_ = true;
        socket_.async_wait(tcp::socket::wait_write, [self = shared_from_this()](error_code fault) {
            self->awaiting_output_ = false;
            if (fault) return self->fail(fault);
            if (!self->closed_ && !self->flush_tail()) self->await_output();
        });
    }

    tcp::socket socket_;
    wire::FrameReader reader_;
    std::string tail_;  // of a frame that the kernel took in part
    std::string peer_;
    std::string reason_;
    bool closed_ = false;
    bool awaiting_input_ = false;
    bool awaiting_output_ = false;
};

class StreamConnection final : public Connection {
  public:
    explicit StreamConnection(std::shared_ptr<Stream> stream) : stream_(std::move(stream)) {}
    ~StreamConnection() override { stream_->close("closed"); }

    bool next_frame(std::string_view& payload) override { return stream_->next_frame(payload); }
    bool send(std::string_view payload) override { return stream_->send(payload); }
    bool ready() override { return stream_->ready(); }
    bool closed() const override { return stream_->closed(); }
    const std::string& close_reason() const override { return stream_->reason(); }
    const std::string& peer() const override { return stream_->peer(); }
    void close(std::string_view reason) override { stream_->close(reason); }

  private:
    std::shared_ptr<Stream> stream_;
};

}  // namespace

std::string text_of(const tcp::endpoint& endpoint) {
    const std::string address = endpoint.address().to_string();
    const std::string host = endpoint.address().is_v6() ? "[" + address + "]" : address;
    return host + ":" + std::to_string(endpoint.port());
}

std::unique_ptr<Connection> make_connection(tcp::socket socket) {
    auto stream = std::make_shared<Stream>(std::move(socket));
    stream->start();
    return std::make_unique<StreamConnection>(std::move(stream));
}

}  // namespace k3d::net
