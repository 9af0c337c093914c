// SPDX-License-Identifier: BSD-3-Clause
#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "common/net/asio.h"
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

int remaining_ms(Clock::time_point deadline) {
    const auto rest = std::chrono::ceil<milliseconds>(deadline - Clock::now()).count();
    return static_cast<int>(std::clamp<long long>(rest, 0, 3'600'000));
}

/// Waits until the socket is ready for `events`; false at the deadline.
bool wait_for(tcp::socket& socket, short events, Clock::time_point deadline) {
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
        : place(host + ":" + std::to_string(port)), reader(wire::kMaxPayloadFromServer) {
        const auto deadline = Clock::now() + patience;
        for (;;) {
            error_code fault;
            const auto endpoints = tcp::resolver(io).resolve(host, std::to_string(port), fault);
            if (!fault && connect(endpoints, deadline, fault)) return;
            if (remaining_ms(deadline) == 0) {
                throw NetError("cannot connect to " + place + ": " + fault.message());
            }
            ::poll(nullptr, 0,
                   std::min(remaining_ms(deadline), static_cast<int>(kRetryPause.count())));
        }
    }

    bool connect(const tcp::resolver::results_type& endpoints, Clock::time_point deadline,
                 error_code& fault) {
        for (const auto& entry : endpoints) {
            socket.close(fault);
            socket.open(entry.endpoint().protocol(), fault);
            if (!fault) socket.non_blocking(true, fault);
            if (!fault) socket.set_option(tcp::no_delay(true), fault);
            if (fault) continue;
            socket.connect(entry.endpoint(), fault);
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

    void send(std::string_view payload) {
        out.clear();
        wire::append_frame(payload, out);
        const auto deadline = Clock::now() + kSendPatience;
        std::string_view rest = out;
        while (!rest.empty()) {
            error_code fault;
            const std::size_t sent = socket.write_some(asio::buffer(rest), fault);
            if (fault == asio::error::would_block) {
                if (!wait_for(socket, POLLOUT, deadline)) {
                    fail("the server has taken no data for " +
                         std::to_string(kSendPatience.count()) + " ms");
                }
            } else if (fault) {
                fail(fault.message());
            }
            rest.remove_prefix(sent);
        }
    }

    bool receive(std::string_view& payload, milliseconds patience) {
        const auto deadline = Clock::now() + patience;
        for (;;) {
            switch (reader.next(payload)) {
                case wire::FrameReader::Status::Frame:
                    return true;
                case wire::FrameReader::Status::TooLong:
                    fail("frame of " + std::to_string(reader.announced_length()) +
                         " bytes announced, limit " + std::to_string(reader.max_payload()));
                case wire::FrameReader::Status::NeedMore:
                    break;
            }
            if (!wait_for(socket, POLLIN, deadline)) {
                fail("no frame for " + std::to_string(patience.count()) + " ms");
            }
            if (!read_some()) return false;
        }
    }

    /// False at the stream's orderly end.
    bool read_some() {
        error_code fault;
        const std::span<char> room = reader.space();
        const std::size_t count = socket.read_some(asio::buffer(room.data(), room.size()), fault);
        if (fault == asio::error::eof) {
            if (reader.buffered() > 0) fail("connection closed in the middle of a frame");
            return false;
        }
        if (fault && fault != asio::error::would_block) fail(fault.message());
        reader.received(count);
        return true;
    }

    asio::io_context io{1};
    tcp::socket socket{io};
    std::string place;
    wire::FrameReader reader;
    std::string out;
};

Client::Client(const std::string& host, std::uint16_t port, milliseconds patience)
    : impl_(std::make_unique<Impl>(host, port, patience)) {}
Client::~Client() = default;

void Client::send(std::string_view payload) {
    impl_->send(payload);
}

bool Client::receive(std::string_view& payload, milliseconds patience) {
    return impl_->receive(payload, patience);
}

}  // namespace k3d::net
