// SPDX-License-Identifier: BSD-3-Clause
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>
#include <vector>

#include "common/clock/deadline.h"
#include "common/net/connection.h"
#include "common/net/net.h"
#include "common/wire/frame.h"

namespace k3d::net {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;
using std::chrono::milliseconds;

namespace {

/// A server that takes nothing for this long has hung.
constexpr milliseconds kSendPatience{30'000};
constexpr milliseconds kRetryPause{20};

/// Waits until the socket is ready for `events`; false at the deadline.
bool wait_for(Socket& socket, short events, Clock::time_point deadline) {
    for (;;) {
        pollfd entry{socket.native_handle(), events, 0};
        const int ready = ::poll(&entry, 1, remaining_ms(deadline));
        if (ready > 0) return true;
        if (ready < 0 && errno != EINTR) throw NetError(std::strerror(errno));
        if (Clock::now() >= deadline) return false;
    }
}

}  // namespace

struct Client::Impl {
    Impl(const std::string& host, std::uint16_t port, milliseconds patience)
        : Impl(host + ":" + std::to_string(port)) {
        connect_within(patience, [&](error_code& fault) {
            std::vector<Endpoint> endpoints;
            for (const auto& entry : tcp::resolver(io).resolve(host, std::to_string(port), fault)) {
                endpoints.emplace_back(entry.endpoint());
            }
            return endpoints;
        });
    }

    Impl(const UnixPath& path, milliseconds patience) : Impl("unix:" + path.name) {
        local = true;
        const Endpoint endpoint = endpoint_of(path, "cannot connect to");
        connect_within(patience, [&](error_code&) { return std::vector{endpoint}; });
    }

    template <class Resolve>
    void connect_within(milliseconds patience, const Resolve& resolve) {
        const auto deadline = Clock::now() + patience;
        for (;;) {
            error_code fault;
            const std::vector<Endpoint> endpoints = resolve(fault);
            if (!fault && connect(endpoints, deadline, fault)) return block();
            if (remaining_ms(deadline) == 0) {
                throw NetError("cannot connect to " + place + ": " + fault.message());
            }
            ::poll(nullptr, 0,
                   std::min(remaining_ms(deadline), static_cast<int>(kRetryPause.count())));
        }
    }

    bool connect(const std::vector<Endpoint>& endpoints, Clock::time_point deadline,
                 error_code& fault) {
        for (const Endpoint& endpoint : endpoints) {
            socket.close(fault);
            socket.open(endpoint.protocol(), fault);
            if (!fault) socket.non_blocking(true, fault);
            if (!fault && is_tcp(endpoint)) socket.set_option(tcp::no_delay(true), fault);
            if (fault) continue;
            socket.connect(endpoint, fault);
            if (fault == asio::error::in_progress || fault == asio::error::would_block) {
                fault = asio::error::timed_out;
                if (wait_for(socket, POLLOUT, deadline)) fault = pending_error();
            }
            if (!fault) return true;
        }
        return false;
    }

    /// How the connection attempt went.
    error_code pending_error() {
        int number = 0;
        socklen_t size = sizeof number;
        if (::getsockopt(socket.native_handle(), SOL_SOCKET, SO_ERROR, &number, &size) != 0) {
            number = errno;
        }
        return {number, asio::error::get_system_category()};
    }

    [[noreturn]] void fail(const std::string& what) { throw NetError(place + ": " + what); }

    /// From now on calls block for as long as their timeouts: one system call a frame, no poll before it.
    void block() {
        error_code fault;
        socket.non_blocking(false, fault);
        if (!fault) socket.native_non_blocking(false, fault);
        if (fault) fail(fault.message());
        set_timeout(SO_SNDTIMEO, kSendPatience);
    }

    void set_timeout(int option, milliseconds longest) {
        const auto ms = std::max<long long>(longest.count(), 1);  // 0 would be for ever
        const timeval time{ms / 1000, 1000 * (ms % 1000)};
        if (::setsockopt(socket.native_handle(), SOL_SOCKET, option, &time, sizeof time) != 0) {
            fail(std::strerror(errno));
        }
    }

    void send(std::string_view payload) {
        out.clear();
        wire::append_frame(payload, out);
        std::string_view rest = out;
        while (!rest.empty()) {
            const ssize_t sent =
                ::send(socket.native_handle(), rest.data(), rest.size(), MSG_NOSIGNAL);
            if (sent >= 0) {
                rest.remove_prefix(static_cast<std::size_t>(sent));
            } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
                fail("the server has taken no data for " + std::to_string(kSendPatience.count()) +
                     " ms");
            } else if (errno == EPIPE && local) {
                return;  // what the server sent before it closed can still be received
            } else if (errno != EINTR) {
                fail(std::strerror(errno));
            }
        }
    }

    bool receive(std::string_view& payload, milliseconds patience) {
        if (patience != patience_set) set_timeout(SO_RCVTIMEO, patience);
        patience_set = patience;
        const auto deadline = Clock::now() + patience;
        for (bool read = false;; read = true) {
            switch (reader.next(payload)) {
                case wire::FrameReader::Status::Frame:
                    return true;
                case wire::FrameReader::Status::TooLong:
                    fail("frame of " + std::to_string(reader.announced_length()) +
                         " bytes announced, limit " + std::to_string(reader.max_payload()));
                case wire::FrameReader::Status::NeedMore:
                    break;
            }
            if (read && Clock::now() >= deadline) no_frame_for(patience);
            if (!read_some(patience)) return false;
        }
    }

    [[noreturn]] void no_frame_for(milliseconds patience) {
        fail("no frame for " + std::to_string(patience.count()) + " ms");
    }

    /// False at the stream's orderly end. Of a Unix-domain socket that is also what it says when the server
    /// closed without reading our last frame.
    bool read_some(milliseconds patience) {
        const std::span<char> room = reader.space();
        const ssize_t count = ::recv(socket.native_handle(), room.data(), room.size(), 0);
        if (count > 0) {
            reader.received(static_cast<std::size_t>(count));
            return true;
        }
        if (count == 0 || (errno == ECONNRESET && local)) {
            if (reader.buffered() > 0) fail("connection closed in the middle of a frame");
            return false;
        }
        if (errno == EAGAIN || errno == EWOULDBLOCK) no_frame_for(patience);
        if (errno != EINTR) fail(std::strerror(errno));
        return true;
    }

    asio::io_context io{1};
    Socket socket{io};
    std::string place;
    wire::FrameReader reader{wire::kMaxPayloadFromServer};
    std::string out;
    bool local = false;             ///< a Unix-domain socket
    milliseconds patience_set{-1};  ///< as the kernel knows it

  private:
    explicit Impl(std::string where) : place(std::move(where)) {}
};

Client::Client(const std::string& host, std::uint16_t port, milliseconds patience)
    : impl_(std::make_unique<Impl>(host, port, patience)) {}
Client::Client(const UnixPath& path, milliseconds patience)
    : impl_(std::make_unique<Impl>(path, patience)) {}
Client::~Client() = default;

void Client::send(std::string_view payload) {
    impl_->send(payload);
}

bool Client::receive(std::string_view& payload, milliseconds patience) {
    return impl_->receive(payload, patience);
}

}  // namespace k3d::net
