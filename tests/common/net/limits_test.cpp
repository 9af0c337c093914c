// SPDX-License-Identifier: BSD-3-Clause
// What one peer may cost: each limit ends that peer's connection, names itself, and hurts nobody.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <vector>

#include "common/net/net.h"
#include "common/wire/frame.h"

namespace k3d::net {
namespace {

using namespace std::chrono_literals;

std::string framed(std::string_view payload) {
    std::string bytes;
    wire::append_frame(payload, bytes);
    return bytes;
}

struct Server {
    explicit Server(const Limits& limits)
        : listener(
              loop, "127.0.0.1", 0,
              [this](std::unique_ptr<Connection> c) { connections.push_back(std::move(c)); },
              limits, [this](const std::string&, const std::string& why) { refusals.push_back(why); }) {}

    bool wait(const std::function<bool()>& done) { return loop.wait(Clock::now() + 10s, done); }
    Connection& accepted(std::size_t count) {
        EXPECT_TRUE(wait([&] { return connections.size() >= count; }));
        return *connections.at(count - 1);
    }
    /// Frames that can be taken until the connection closes, and why it did.
    std::pair<int, std::string> until_closed(Connection& connection) {
        int frames = 0;
        EXPECT_TRUE(wait([&] {
            std::string_view payload;
            while (connection.next_frame(payload)) ++frames;
            return connection.closed();
        }));
        return {frames, connection.close_reason()};
    }

    Loop loop;
    std::vector<std::unique_ptr<Connection>> connections;
    std::vector<std::string> refusals;
    Listener listener;
};

struct Peer {
    int fd = ::socket(AF_INET, SOCK_STREAM, 0);
    explicit Peer(std::uint16_t port) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(::connect(fd, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    }
    ~Peer() { ::close(fd); }
    Peer(const Peer&) = delete;
    Peer& operator=(const Peer&) = delete;
    void send(const std::string& bytes) const {
        EXPECT_EQ(::send(fd, bytes.data(), bytes.size(), MSG_NOSIGNAL),
                  static_cast<ssize_t>(bytes.size()));
    }
};

TEST(Limits, BytesOfACycle) {
    Server server({.cycle_bytes = 5000});
    server.listener.begin_cycle();
    Peer peer(server.listener.port());
    Connection& connection = server.accepted(1);
    peer.send(framed(std::string(4996, 'x')));
    std::string_view payload;
    EXPECT_TRUE(server.wait([&] { return connection.next_frame(payload); })) << "exactly the limit";
    server.listener.begin_cycle();
    peer.send(framed(std::string(4997, 'x')));
    const auto [frames, reason] = server.until_closed(connection);
    EXPECT_EQ(frames, 0);
    EXPECT_EQ(reason, "has sent 5001 bytes in one cycle, limit 5000");
}

TEST(Limits, FramesOfACycle) {
    Server server({.cycle_frames = 10});
    server.listener.begin_cycle();
    Peer peer(server.listener.port());
    std::string bytes;
    for (int i = 0; i < 11; ++i) bytes += framed("(syn)");
    peer.send(bytes);
    const auto [frames, reason] = server.until_closed(server.accepted(1));
    EXPECT_EQ(frames, 10);
    EXPECT_EQ(reason, "has sent 11 frames in one cycle, limit 10");
}

TEST(Limits, FrameLength) {
    Server server({.frame = 100});
    Peer peer(server.listener.port());
    peer.send(framed(std::string(100, 'x')) + framed(std::string(101, 'x')));
    const auto [frames, reason] = server.until_closed(server.accepted(1));
    EXPECT_EQ(frames, 1);
    EXPECT_EQ(reason, "frame of 101 bytes announced, limit 100");
}

TEST(Limits, WhatAPeerDoesNotRead) {
    Server server({.unsent = 100'000});
    Peer peer(server.listener.port());
    Connection& connection = server.accepted(1);
    const std::string payload(30'000, 'x');
    int dropped = 0;
    for (int i = 0; i < 10'000 && !connection.closed(); ++i) dropped += connection.send(payload) ? 0 : 1;
    EXPECT_EQ(dropped, 4) << "the fourth makes it 120,016 bytes";
    EXPECT_EQ(connection.close_reason(), "reads nothing: 120016 bytes dropped, limit 100000");
}

TEST(Limits, ConnectionsAtATime) {
    Server server({.connections = 2});
    Peer first(server.listener.port());
    Peer second(server.listener.port());
    server.accepted(2);
    Peer third(server.listener.port());
    EXPECT_TRUE(server.wait([&] { return !server.refusals.empty(); }));
    EXPECT_EQ(server.refusals.at(0), "2 connections open, limit 2");
    char byte = 0;
    EXPECT_EQ(::recv(third.fd, &byte, 1, 0), 0) << "closed at once";
    // A place is free again as soon as one is closed.
    server.connections[0]->close("enough");
    Peer fourth(server.listener.port());
    server.accepted(3);
    EXPECT_EQ(server.refusals.size(), 1U);
}

TEST(Limits, AClosedPeerKeepsItsPlaceUntilItsLastFramesAreRead) {
    Server server({.connections = 1});
    {
        Peer peer(server.listener.port());
        server.accepted(1);
        peer.send(framed("(killsim)"));
    }
    Connection& connection = *server.connections[0];
    EXPECT_TRUE(server.wait([&] { return connection.closed(); }));
    EXPECT_FALSE(connection.spent());
    Peer second(server.listener.port());
    EXPECT_TRUE(server.wait([&] { return !server.refusals.empty(); }));
    std::string_view payload;
    EXPECT_TRUE(connection.next_frame(payload));
    EXPECT_EQ(payload, "(killsim)");
    EXPECT_FALSE(connection.next_frame(payload));
    EXPECT_TRUE(connection.spent());
    Peer third(server.listener.port());
    server.accepted(2);
}

}  // namespace
}  // namespace k3d::net
