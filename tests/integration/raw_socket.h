// SPDX-License-Identifier: BSD-3-Clause
// A bare TCP socket for sending what no client of ours would send.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <string>

namespace k3d::testing {

class RawSocket {
  public:
    explicit RawSocket(std::uint16_t port) : fd_(::socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        if (::connect(fd_, reinterpret_cast<sockaddr*>(&address), sizeof(address)) != 0) {
            ::close(fd_);
            throw std::runtime_error("cannot connect to port " + std::to_string(port));
        }
    }
    ~RawSocket() { ::close(fd_); }
    RawSocket(const RawSocket&) = delete;
    RawSocket& operator=(const RawSocket&) = delete;

    /// What the peer takes of it; a closed connection takes nothing.
    void write(const std::string& bytes) {
        [[maybe_unused]] const auto sent = ::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    }

    /// As much of it as goes without waiting; false once the peer has closed.
    bool pour(const std::string& bytes) {
        return ::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT) >= 0 ||
               errno == EAGAIN;
    }

    /// No more will come, but it stays open for reading.
    void end_writing() { ::shutdown(fd_, SHUT_WR); }

    /// True once the peer has closed; data that comes before is read and dropped.
    bool closed_by_peer(std::chrono::milliseconds patience) {
        const auto deadline = std::chrono::steady_clock::now() + patience;
        while (std::chrono::steady_clock::now() < deadline) {
            pollfd waiting{fd_, POLLIN, 0};
            if (::poll(&waiting, 1, 100) <= 0) continue;
            char buffer[4096];
            if (::recv(fd_, buffer, sizeof(buffer), 0) <= 0) return true;
        }
        return false;
    }

  private:
    int fd_;
};

}  // namespace k3d::testing
