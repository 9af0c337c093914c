// SPDX-License-Identifier: BSD-3-Clause
// A peer made of bytes, for tests of the HTTP server: independent of Asio and Beast, in the
// thread of the loop it talks to.
#pragma once

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "common/net/net.h"

namespace k3d::test {

using namespace std::chrono_literals;

/// Far beyond what anything here takes: reaching it is a failure, not a measurement.
inline constexpr std::chrono::seconds kPatience{20};

class RawPeer {
  public:
    /// `receive_buffer` > 0 makes it a peer that can hold only so many unread bytes.
    explicit RawPeer(std::uint16_t port, int receive_buffer = 0)
        : fd_(::socket(AF_INET, SOCK_STREAM, 0)) {
        if (receive_buffer > 0) {
            ::setsockopt(fd_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
        }
        sockaddr_in to{};
        to.sin_family = AF_INET;
        to.sin_port = htons(port);
        to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        if (::connect(fd_, reinterpret_cast<sockaddr*>(&to), sizeof to) != 0) {
            throw std::runtime_error("test peer cannot connect");
        }
        ::fcntl(fd_, F_SETFL, O_NONBLOCK);
    }
    ~RawPeer() { ::close(fd_); }
    RawPeer(const RawPeer&) = delete;
    RawPeer& operator=(const RawPeer&) = delete;

    /// What fits into the kernel; a closed connection takes nothing.
    void send(std::string_view bytes) {
        (void)::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    }

    void take() {
        char chunk[65536];
        for (;;) {
            const ssize_t n = ::recv(fd_, chunk, sizeof chunk, 0);
            if (n > 0) {
                received_.append(chunk, static_cast<std::size_t>(n));
                continue;
            }
            closed_ = closed_ || n == 0 || (errno != EAGAIN && errno != EINTR);
            return;
        }
    }

    /// Reads while the loop runs until `done()`; false after kPatience.
    bool until(net::Loop& loop, const std::function<bool()>& done) {
        const auto give_up = net::Clock::now() + kPatience;
        for (;;) {
            take();
            if (done()) return true;
            if (net::Clock::now() > give_up) return false;
            loop.wait(net::Clock::now() + 1ms, [] { return false; });
        }
    }
    bool until_closed(net::Loop& loop) {
        return until(loop, [this] { return closed_; });
    }

    /// One whole answer (header and Content-Length bytes), taken off what was received.
    std::string answer(net::Loop& loop) {
        std::string whole;
        until(loop, [&] { return cut_answer(whole) || closed_; });
        return whole;
    }

    /// Upgrades to a WebSocket with the example key of RFC 6455; false if refused.
    bool open_socket(net::Loop& loop, const std::string& path = "/stream") {
        send("GET " + path +
             " HTTP/1.1\r\nHost: x\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
             "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n");
        until(loop, [&] { return closed_ || received_.find("\r\n\r\n") != std::string::npos; });
        const std::size_t end = received_.find("\r\n\r\n");
        if (end == std::string::npos) return false;
        const std::string header = received_.substr(0, end + 4);
        received_.erase(0, end + 4);
        return header.find(" 101 ") != std::string::npos &&
               header.find("s3pPLMBiTxaQ9kYGzzhZRbK+xOo=") != std::string::npos;
    }

    /// Takes one whole WebSocket message (unfragmented text) off what was received.
    bool cut_message(std::string& message) {
        if (received_.size() < 2) return false;
        const auto byte = [this](std::size_t i) { return static_cast<std::uint8_t>(received_[i]); };
        std::size_t length = byte(1) & 0x7fu;
        std::size_t head = 2;
        const std::size_t extra = length == 126 ? 2 : length == 127 ? 8 : 0;
        if (received_.size() < head + extra) return false;
        if (extra > 0) length = 0;
        for (std::size_t i = 0; i < extra; ++i) length = length * 256 + byte(head++);
        if (received_.size() < head + length) return false;
        if (byte(0) != 0x81) throw std::runtime_error("not a whole text message");
        message = received_.substr(head, length);
        received_.erase(0, head + length);
        return true;
    }

    std::string& received() { return received_; }
    bool closed() const { return closed_; }

  private:
    bool cut_answer(std::string& whole) {
        const std::size_t end = received_.find("\r\n\r\n");
        if (end == std::string::npos) return false;
        const std::size_t at = received_.find("Content-Length: ");
        const std::size_t length = at < end ? std::stoul(received_.substr(at + 16)) : 0;
        if (received_.size() < end + 4 + length) return false;
        whole = received_.substr(0, end + 4 + length);
        received_.erase(0, end + 4 + length);
        return true;
    }

    int fd_;
    std::string received_;
    bool closed_ = false;
};

}  // namespace k3d::test
