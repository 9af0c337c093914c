// SPDX-License-Identifier: BSD-3-Clause
#include "common/net/connection.h"

#include <poll.h>

#include <algorithm>
#include <array>

#include "common/wire/frame.h"

namespace k3d::net {

namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;
using std::chrono::milliseconds;

/// Socket and buffers. Handlers hold it, so it outlives the Connection until the last has run.
class Stream : public std::enable_shared_from_this<Stream> {
  public:
    Stream(Socket socket, std::string peer, std::shared_ptr<Shared> shared)
        : socket_(std::move(socket)),
          shared_(std::move(shared)),
          reader_(limits().frame),
          peer_(std::move(peer)) {
        ++shared_->open;
    }
    ~Stream() { release(); }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;

    void start() {
        error_code fault;
        socket_.non_blocking(true, fault);
        if (!fault && is_tcp(socket_.local_endpoint(fault))) {
            socket_.set_option(tcp::no_delay(true), fault);
        }
        if (fault) return close(fault.message());
        await_input();
    }

    bool next_frame(std::string_view& payload) {
        if (rejected_) return false;
        const auto status = reader_.next(payload);
        if (closed_ && status != wire::FrameReader::Status::Frame) release();
        if (status == wire::FrameReader::Status::TooLong) {
            reject("frame of", reader_.announced_length(), "bytes announced", limits().frame);
            return false;
        }
        if (status == wire::FrameReader::Status::Frame && !counted(0, 1)) return false;
        // Room again: go on where the buffer's limit stopped the reading.
        if (!awaiting_input_) await_input();
        return status == wire::FrameReader::Status::Frame;
    }

    bool send(std::string_view payload) {
        if (closed_) return false;
        if (!flush_tail()) return drop(payload);
        const auto length = static_cast<std::uint32_t>(payload.size());
        const std::array<unsigned char, wire::kPrefixBytes> prefix{
            static_cast<unsigned char>(length >> 24), static_cast<unsigned char>(length >> 16),
            static_cast<unsigned char>(length >> 8), static_cast<unsigned char>(length)};
        const std::array<asio::const_buffer, 2> parts{asio::buffer(prefix),
                                                      asio::buffer(payload.data(), payload.size())};
        error_code fault;
        const std::size_t sent = socket_.write_some(parts, fault);
        if (fault == asio::error::would_block) return drop(payload);  // nothing of it is out
        if (fault) {
            fail(fault);
            return false;
        }
        dropped_bytes_ = 0;
        if (sent < prefix.size() + payload.size()) keep_tail(prefix, payload, sent);
        return true;
    }

    bool ready() { return !closed_ && flush_tail(); }

    void doze(milliseconds longest) {
        if (closed_ || full() || reader_.holds_frame()) return;
        pollfd entry{socket_.native_handle(), POLLIN, 0};
        ::poll(&entry, 1, static_cast<int>(longest.count()));  // why it returns is the loop's to see
    }

    void close(std::string_view reason) {
        if (closed_) return;
        closed_ = true;
        reason_ = reason;
        if (rejected_ || !reader_.holds_frame()) release();
        error_code ignored;
        socket_.shutdown(Socket::shutdown_both, ignored);
        socket_.close(ignored);
    }

    /// Gives its place among the listener's connections to another.
    void release() {
        if (!released_) --shared_->open;
        released_ = true;
    }

    bool closed() const { return closed_; }
    bool spent() const { return released_; }
    bool broke_limit() const { return rejected_; }
    const std::string& reason() const { return reason_; }
    const std::string& peer() const { return peer_; }

  private:
    const Limits& limits() const { return shared_->limits; }

    /// A frame and its prefix must fit in any case, or a long one would never be whole.
    bool full() const {
        return reader_.buffered() >= std::max(limits().unread, limits().frame + wire::kPrefixBytes);
    }

    /// Closes for good: what has arrived is not read any more.
    void reject(std::string_view what, std::size_t value, std::string_view unit,
                std::size_t limit) {
        rejected_ = true;
        close(std::string(what) + " " + std::to_string(value) + " " + std::string(unit) +
              ", limit " + std::to_string(limit));
    }

    /// Adds to this cycle's input; false if that is too much.
    bool counted(std::size_t bytes, std::size_t frames) {
        if (shared_->cycle == 0) return true;
        if (cycle_ != shared_->cycle) cycle_bytes_ = cycle_frames_ = 0;
        cycle_ = shared_->cycle;
        cycle_bytes_ += bytes;
        cycle_frames_ += frames;
        if (cycle_bytes_ > limits().cycle_bytes) {
            reject("has sent", cycle_bytes_, "bytes in one cycle", limits().cycle_bytes);
        } else if (cycle_frames_ > limits().cycle_frames) {
            reject("has sent", cycle_frames_, "frames in one cycle", limits().cycle_frames);
        }
        return !rejected_;
    }

    /// Leaves a frame out, because the peer does not read.
    bool drop(std::string_view payload) {
        dropped_bytes_ += wire::kPrefixBytes + payload.size();
        if (limits().unsent > 0 && dropped_bytes_ > limits().unsent) {
            reject("reads nothing:", dropped_bytes_, "bytes dropped", limits().unsent);
        }
        return false;
    }

    void await_input() {
        if (closed_ || full()) return;
        awaiting_input_ = true;
        socket_.async_wait(Socket::wait_read, [self = shared_from_this()](error_code fault) {
            self->awaiting_input_ = false;
            if (fault) return self->fail(fault);
            self->read_available();
            self->await_input();
        });
    }

    /// Reads what is there, up to the limit. Closes at the stream's end.
    void read_available() {
        while (!closed_ && !full()) {
            const std::span<char> room = reader_.space();
            error_code fault;
            const std::size_t count =
                socket_.read_some(asio::buffer(room.data(), room.size()), fault);
            if (fault == asio::error::would_block) return;
            if (fault == asio::error::eof) return close("peer closed");
            if (fault) return close(fault.message());
            reader_.received(count);
            if (!counted(count, 0) || count < room.size()) return;
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
        socket_.async_wait(Socket::wait_write, [self = shared_from_this()](error_code fault) {
            self->awaiting_output_ = false;
            if (fault) return self->fail(fault);
            if (!self->closed_ && !self->flush_tail()) self->await_output();
        });
    }

    Socket socket_;
    std::shared_ptr<Shared> shared_;
    wire::FrameReader reader_;
    std::uint64_t cycle_ = 0;  // that the two counts are of
    std::size_t cycle_bytes_ = 0;
    std::size_t cycle_frames_ = 0;
    std::size_t dropped_bytes_ = 0;  // since a frame last went out
    std::string tail_;  // of a frame that the kernel took in part
    std::string peer_;
    std::string reason_;
    bool closed_ = false;
    bool rejected_ = false;
    bool released_ = false;
    bool awaiting_input_ = false;
    bool awaiting_output_ = false;
};

class StreamConnection final : public Connection {
  public:
    explicit StreamConnection(std::shared_ptr<Stream> stream) : stream_(std::move(stream)) {}
    ~StreamConnection() override {
        stream_->close("closed");
        stream_->release();  // the last handler may hold it longer
    }

    bool next_frame(std::string_view& payload) override { return stream_->next_frame(payload); }
    bool send(std::string_view payload) override { return stream_->send(payload); }
    bool ready() override { return stream_->ready(); }
    void doze(milliseconds longest) override { stream_->doze(longest); }
    bool closed() const override { return stream_->closed(); }
    bool spent() const override { return stream_->spent(); }
    bool broke_limit() const override { return stream_->broke_limit(); }
    const std::string& close_reason() const override { return stream_->reason(); }
    const std::string& peer() const override { return stream_->peer(); }
    void close(std::string_view reason) override { stream_->close(reason); }

  private:
    std::shared_ptr<Stream> stream_;
};

}  // namespace

bool is_tcp(const Endpoint& endpoint) {
    const int family = endpoint.data()->sa_family;
    return family == AF_INET || family == AF_INET6;
}

Endpoint endpoint_of(const UnixPath& path, const std::string& cannot) {
    if (path.name.empty() || path.name.size() > kMaxUnixPath) {
        throw NetError(cannot + " unix:" + path.name + ": a name of " +
                       std::to_string(path.name.size()) + " bytes, limit " +
                       std::to_string(kMaxUnixPath));
    }
    return boost::asio::local::stream_protocol::endpoint(path.name);
}

std::unique_ptr<Connection> make_connection(Socket socket, std::string peer,
                                            std::shared_ptr<Shared> shared) {
    auto stream = std::make_shared<Stream>(std::move(socket), std::move(peer), std::move(shared));
    stream->start();
    return std::make_unique<StreamConnection>(std::move(stream));
}

}  // namespace k3d::net
