// SPDX-License-Identifier: BSD-3-Clause
// A small HTTP/1.1 + WebSocket server: the files of one folder, and one path that becomes a
// WebSocket. It only tells: a peer that sends a message over its WebSocket is cut off.
//
// Driven by net::Loop: nothing happens outside poll() and wait(). Answers 200, 400 (malformed),
// 404, 405 (neither GET nor HEAD), 426 (no WebSocket where only one is served), 431 (header too
// long), 503 (too many connections); whatever else a peer sends costs that peer its connection and
// nobody else anything.
// The only folder that includes Boost.Beast; nothing of it shows in this header.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "common/net/net.h"

namespace k3d::http {

/// What one peer, and all together, may cost us.
struct Limits {
    std::size_t connections = 64;          ///< open at once, WebSockets included
    std::size_t header_bytes = 8 * 1024;   ///< of one request
    std::size_t message_bytes = 4 * 1024;  ///< of one message from a WebSocket's peer
    std::size_t send_buffer =
        64 * 1024;  ///< kernel's, of a WebSocket: bounds how stale a page can be
    std::chrono::milliseconds request{10'000};  ///< for a whole header to come; idle keep-alive too
    std::chrono::milliseconds answer{30'000};   ///< for a whole file to be taken
    std::chrono::milliseconds silence{30'000};  ///< a WebSocket's peer that answers no ping
};

/// Our end of one WebSocket. Destroying it closes the connection.
class Socket {
  public:
    enum class Kind { Text, Binary };

    virtual ~Socket() = default;
    /// Nothing unsent: the next send() is taken.
    virtual bool ready() const = 0;
    /// Hands one message over. At most one is ever held: while the one before is unsent, or after
    /// the end, this one is dropped whole. Returns false if dropped.
    virtual bool send(Kind kind, std::string_view message) = 0;
    virtual bool closed() const = 0;
};

class Server {
  public:
    struct Options {
        std::string address = "127.0.0.1";
        std::uint16_t port = 0;  ///< 0 = any free one
        std::string folder;      ///< whose files are served
        std::string socket_path = "/stream";
        Limits limits = {};
    };
    /// Called from within the loop for every WebSocket that opens.
    using OnSocket = std::function<void(std::unique_ptr<Socket>)>;

    /// Throws net::NetError, e.g. "cannot listen on 127.0.0.1:8080: Address already in use".
    Server(net::Loop& loop, Options options, OnSocket on_socket);
    /// Closes every connection. The loop must outlive the server.
    ~Server();

    std::uint16_t port() const;
    std::size_t connections() const;  ///< open now, WebSockets included

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace k3d::http
