// SPDX-License-Identifier: BSD-3-Clause
// Sockets of the product: framed connections over TCP, or over Unix-domain sockets between processes of one
// machine, driven by one single-threaded loop.
// The only folder (with common/http) that includes Asio; nothing of Asio shows in this header.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace k3d::net {

using Clock = std::chrono::steady_clock;

/// What a socket call could not do, with address and port in the message.
class NetError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What one peer of a listener may cost. A peer that goes beyond a limit loses its connection, and
/// the reason names limit and value; nobody else notices. A cycle lasts from one call of
/// Listener::begin_cycle() to the next; without any there is no limit on a cycle's input.
struct Limits {
    std::size_t connections = 64;      ///< not spent at a time; further ones are refused
    std::size_t frame = 64 * 1024;     ///< bytes a frame may announce
    std::size_t cycle_bytes = 256 * 1024;
    std::size_t cycle_frames = 1000;
    /// Bytes of frames dropped in a row because the peer reads nothing; 0: it may drop for ever.
    std::size_t unsent = 0;
    /// Bytes that wait for next_frame(). Beyond it nothing is read: TCP holds the peer back.
    std::size_t unread = 256 * 1024;
};

/// The event loop. Everything happens inside poll() and wait(); no threads.
class Loop {
  public:
    Loop();
    ~Loop();
    Loop(const Loop&) = delete;
    Loop& operator=(const Loop&) = delete;

    /// Runs what is ready now, but not for ever: peers may send faster than we read.
    void poll();
    /// Runs handlers until `done()` holds (true) or the deadline passes (false). It is asked ten
    /// times a second and more, so that it may look at what no socket tells, such as a signal.
    bool wait(Clock::time_point deadline, const std::function<bool()>& done);

    struct Impl;
    Impl& impl() { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

/// One framed connection. Reading goes on in the background of the loop up to Limits::unread
/// bytes, then waits for the owner (back-pressure on the peer).
class Connection {
  public:
    virtual ~Connection() = default;

    /// Oldest whole frame not yet taken; the view is valid until the next call on this connection
    /// or on the loop.
    virtual bool next_frame(std::string_view& payload) = 0;
    /// Takes prefix and payload to the kernel in one write. If an earlier frame's tail is still
    /// unsent, this frame is dropped whole, so framing never breaks and nothing blocks
    /// (reference 1.8), and counts towards Limits::unsent. Returns false if dropped.
    virtual bool send(std::string_view payload) = 0;
    /// True if the connection is open and nothing of an earlier frame is unsent: whoever composes
    /// frames for watchers need not compose one that send() would drop.
    virtual bool ready() = 0;
    /// Sleeps until this peer has sent something or has gone, or for `longest`; all others wait. Who waits
    /// for many peers wakes once, not for each, if it dozes on the one that answers last.
    virtual void doze(std::chrono::milliseconds /*longest*/) {}
    virtual bool closed() const = 0;                  ///< by the peer, by an error or by close()
    virtual bool spent() const = 0;  ///< closed, and next_frame() has nothing left
    virtual bool broke_limit() const = 0;  ///< why it was closed
    virtual const std::string& close_reason() const = 0;  ///< "peer closed", "frame of 4294967295 bytes announced, limit 65536", ...
    virtual const std::string& peer() const = 0;      ///< "127.0.0.1:51234" or "unix:PATH"
    virtual void close(std::string_view reason) = 0;
};

/// Where a Unix-domain socket is: a file name of at most kMaxUnixPath bytes.
struct UnixPath {
    std::string name;
};
inline constexpr std::size_t kMaxUnixPath = 107;

/// Listens and hands over every accepted connection.
class Listener {
  public:
    using OnAccept = std::function<void(std::unique_ptr<Connection>)>;
    /// Peer and reason of a connection that was closed at once.
    using OnRefuse = std::function<void(const std::string& peer, const std::string& why)>;

    /// Port 0 takes any free one. Throws NetError, e.g. "cannot listen on 127.0.0.1:3100: Address already in use".
    Listener(Loop& loop, const std::string& address, std::uint16_t port, OnAccept on_accept,
             const Limits& limits = {}, OnRefuse on_refuse = {});
    /// On a Unix-domain socket, a file that this listener makes and removes.
    Listener(Loop& loop, const UnixPath& path, OnAccept on_accept, const Limits& limits = {},
             OnRefuse on_refuse = {});
    ~Listener();
    std::uint16_t port() const;  ///< of a TCP listener
    /// From here on every connection's input counts anew.
    void begin_cycle();

  private:
    struct Impl;
    std::shared_ptr<Impl> impl_;
};

/// Blocking client end, as an agent uses it.
class Client {
  public:
    /// Retries until the deadline (the server may still be starting). Throws NetError.
    Client(const std::string& host, std::uint16_t port, std::chrono::milliseconds patience);
    Client(const UnixPath& path, std::chrono::milliseconds patience);
    ~Client();

    void send(std::string_view payload);                       ///< throws NetError if closed
    /// Next payload; false if the server closed the connection in order. The view is valid until
    /// the next call. Throws NetError on errors or after `patience` without a frame.
    bool receive(std::string_view& payload, std::chrono::milliseconds patience);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace k3d::net
