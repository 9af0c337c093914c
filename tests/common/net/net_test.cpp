// SPDX-License-Identifier: BSD-3-Clause
// Framed connections over loopback: both ends in one process, no threads.
#include "common/net/net.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

#include "common/wire/frame.h"

namespace k3d::net {
namespace {

using namespace std::chrono_literals;

/// A listener on a free port that keeps every connection.
struct Server {
    Loop loop;
    std::vector<std::unique_ptr<Connection>> connections;
    Listener listener{loop, "127.0.0.1", 0, [this](std::unique_ptr<Connection> connection) {
                          connections.push_back(std::move(connection));
                      }};

    bool wait(const std::function<bool()>& done) { return loop.wait(Clock::now() + 10s, done); }
    Connection& accepted(std::size_t count = 1) {
        EXPECT_TRUE(wait([&] { return connections.size() >= count; }));
        return *connections.at(count - 1);
    }
    /// The next frame of a connection, or "closed: reason".
    std::string frame(Connection& connection) {
        std::string_view payload;
        bool got = false;
        EXPECT_TRUE(wait([&] {
            got = connection.next_frame(payload);
            return got || connection.closed();
        }));
        return got ? std::string(payload) : "closed: " + connection.close_reason();
    }
};

/// A plain socket, to send what Client never would.
struct RawSocket {
    int fd = ::socket(AF_INET, SOCK_STREAM, 0);
    explicit RawSocket(std::uint16_t port, int receive_buffer = 0) {
        if (receive_buffer > 0) {
            ::setsockopt(fd, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
        }
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(::connect(fd, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    }
    ~RawSocket() { close(); }
    void close() {
        if (fd >= 0) ::close(fd);
        fd = -1;
    }
    void send(std::string_view bytes) const {
        EXPECT_EQ(::send(fd, bytes.data(), bytes.size(), MSG_NOSIGNAL),
                  static_cast<ssize_t>(bytes.size()));
    }
};

TEST(Net, FramesBothWays) {
    Server server;
    Client client("127.0.0.1", server.listener.port(), 5000ms);
    client.send("(init)");
    client.send("");
    client.send("(syn)");
    Connection& connection = server.accepted();
    EXPECT_THAT(connection.peer(), testing::StartsWith("127.0.0.1:"));
    EXPECT_EQ(server.frame(connection), "(init)");
    EXPECT_EQ(server.frame(connection), "");
    EXPECT_EQ(server.frame(connection), "(syn)");
    EXPECT_TRUE(connection.ready());
    EXPECT_TRUE(connection.send("(time (now 1.00))"));
    EXPECT_TRUE(connection.send("(See )"));
    std::string_view payload;
    ASSERT_TRUE(client.receive(payload, 5000ms));
    EXPECT_EQ(payload, "(time (now 1.00))");
    ASSERT_TRUE(client.receive(payload, 5000ms));
    EXPECT_EQ(payload, "(See )");
}

TEST(Net, LastFramesOfAPeerThatLeftAreStillRead) {
    Server server;
    {
        Client client("127.0.0.1", server.listener.port(), 5000ms);
        // An unread answer makes the kernel send a reset at close.
        server.accepted().send("(never read)");
        client.send("(killsim)");
    }
    Connection& connection = *server.connections[0];
    EXPECT_EQ(server.frame(connection), "(killsim)");
    EXPECT_THAT(server.frame(connection), testing::StartsWith("closed: "));
    EXPECT_FALSE(connection.ready());
    EXPECT_FALSE(connection.send("(late)"));
}

TEST(Net, PeerThatClosesIsNamedSo) {
    Server server;
    { Client client("127.0.0.1", server.listener.port(), 5000ms); }
    EXPECT_EQ(server.frame(server.accepted()), "closed: peer closed");
}

TEST(Net, ClientSeesAnOrderlyEnd) {
    Server server;
    Client client("127.0.0.1", server.listener.port(), 5000ms);
    server.accepted().send("last");
    server.connections.clear();
    std::string_view payload;
    ASSERT_TRUE(client.receive(payload, 5000ms));
    EXPECT_EQ(payload, "last");
    EXPECT_FALSE(client.receive(payload, 5000ms));
}

TEST(Net, ClientReceiveHasADeadline) {
    Server server;
    Client client("127.0.0.1", server.listener.port(), 5000ms);
    std::string_view payload;
    EXPECT_THROW(client.receive(payload, 20ms), NetError);
}

TEST(Net, HugeLengthClosesThatConnectionOnly) {
    Server server;
    RawSocket bad(server.listener.port());
    bad.send("\xFF\xFF\xFF\xFF(he1 1)");
    Connection& first = server.accepted(1);
    EXPECT_EQ(server.frame(first), "closed: frame of 4294967295 bytes announced, limit 65536");
    Client good("127.0.0.1", server.listener.port(), 5000ms);
    good.send("(syn)");
    EXPECT_EQ(server.frame(server.accepted(2)), "(syn)");
}

TEST(Net, HalfAFrameWaitsAndDiesWithItsPeer) {
    Server server;
    RawSocket peer(server.listener.port());
    peer.send(std::string_view("\0\0\0\12(he", 7));
    Connection& connection = server.accepted();
    std::string_view payload;
    EXPECT_FALSE(
        server.loop.wait(Clock::now() + 30ms, [&] { return connection.next_frame(payload); }));
    EXPECT_FALSE(connection.closed());
    peer.close();
    EXPECT_EQ(server.frame(connection), "closed: peer closed");
}

TEST(Net, UnreadPeerLosesWholeFramesAndNeverItsFraming) {
    Server server;
    RawSocket peer(server.listener.port(), 65'536);
    Connection& connection = server.accepted();
    const auto numbered = [](int i) {
        std::string payload = std::to_string(i) + " ";
        payload.resize(30'000, static_cast<char>('a' + i % 26));
        return payload;
    };
    int dropped = 0;
    int sent = 0;
    for (; dropped < 5 && sent < 10'000; ++sent) dropped += connection.send(numbered(sent)) ? 0 : 1;
    EXPECT_EQ(dropped, 5) << "the kernel's buffers must fill up";
    EXPECT_FALSE(connection.closed());

    // Reading again: whole frames in order, gaps only at dropped ones, then new ones.
    wire::FrameReader reader(1 << 20);
    int last = -1;
    int received = 0;
    bool gap = false;
    std::vector<char> bytes(100'000);
    const auto deadline = Clock::now() + 20s;
    while (!(gap && received > 5) && Clock::now() < deadline) {
        const ssize_t count = ::recv(peer.fd, bytes.data(), bytes.size(), MSG_DONTWAIT);
        if (count > 0) reader.append({bytes.data(), static_cast<std::size_t>(count)});
        std::string_view payload;
        while (reader.next(payload) == wire::FrameReader::Status::Frame) {
            const int number = std::stoi(std::string(payload.substr(0, 8)));
            EXPECT_EQ(payload, numbered(number));
            EXPECT_GT(number, last);
            gap = gap || number > last + 1;
            last = number;
            ++received;
        }
        connection.send(numbered(sent++));
        server.loop.poll();
    }
    EXPECT_GT(received, 5);
    EXPECT_TRUE(gap) << "last " << last << " of " << sent;
}

TEST(Net, FloodIsHeldBackAndNothingIsLost) {
    Server server;
    RawSocket peer(server.listener.port());
    Connection& connection = server.accepted();
    std::string frame;
    wire::append_frame(std::string(1000, 'x'), frame);
    const int flags = MSG_DONTWAIT | MSG_NOSIGNAL;
    std::size_t pushed = 0;
    // As long as nobody takes frames, reading stops and the peer's sends do, too.
    std::string pending;
    for (int round = 0; round < 20'000; ++round) {
        if (pending.empty()) pending = frame;
        const ssize_t count = ::send(peer.fd, pending.data(), pending.size(), flags);
        if (count > 0) {
            pushed += static_cast<std::size_t>(count);
            pending.erase(0, static_cast<std::size_t>(count));
        }
        server.loop.poll();
    }
    EXPECT_LT(pushed, 19'000'000U);
    const std::size_t whole = pushed / frame.size();
    std::size_t taken = 0;
    std::string_view payload;
    EXPECT_TRUE(server.wait([&] {
        while (connection.next_frame(payload)) ++taken;
        return taken == whole;
    })) << taken
        << " of " << whole;
}

TEST(Net, BusyPortAndBadAddressAreNamed) {
    Server server;
    const std::string port = std::to_string(server.listener.port());
    const auto error_of = [](const auto& action) -> std::string {
        try {
            action();
        } catch (const NetError& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_EQ(error_of([&] {
                  Listener second(server.loop, "127.0.0.1", server.listener.port(), [](auto) {});
              }),
              "cannot listen on 127.0.0.1:" + port + ": Address already in use");
    EXPECT_EQ(error_of([&] { Listener bad(server.loop, "nowhere", 1, [](auto) {}); }),
              "cannot listen on nowhere:1: not an IP address");
    std::uint16_t free_port = 0;
    {
        Server other;
        free_port = other.listener.port();
    }
    EXPECT_EQ(error_of([&] { Client client("127.0.0.1", free_port, 40ms); }),
              "cannot connect to 127.0.0.1:" + std::to_string(free_port) + ": Connection refused");
}

/// A name in the temporary folder that is this test process's own.
UnixPath unix_path() {
    return {(std::filesystem::temp_directory_path() / ("k3d-net-" + std::to_string(::getpid())))
                .string()};
}

TEST(Net, FramesBothWaysOverAUnixDomainSocket) {
    const UnixPath path = unix_path();
    {
        Loop loop;
        std::unique_ptr<Connection> connection;
        Listener listener(loop, path, [&](auto accepted) { connection = std::move(accepted); });
        Client client(path, 5000ms);
        const std::string large(50'000, 'x');  // more than one read
        client.send("(syn)");
        client.send(large);
        std::vector<std::string> frames;
        EXPECT_TRUE(loop.wait(Clock::now() + 10s, [&] {
            std::string_view payload;
            while (connection && connection->next_frame(payload)) frames.emplace_back(payload);
            return frames.size() == 2;
        }));
        EXPECT_THAT(frames, testing::ElementsAre("(syn)", large));
        EXPECT_EQ(connection->peer(), "unix:" + path.name);
        EXPECT_TRUE(connection->send("(See )"));
        std::string_view payload;
        ASSERT_TRUE(client.receive(payload, 5000ms));
        EXPECT_EQ(payload, "(See )");
        connection.reset();
        EXPECT_FALSE(client.receive(payload, 5000ms)) << "an orderly end";
    }
    EXPECT_FALSE(std::filesystem::exists(path.name)) << "the listener removes its file";
}

TEST(Net, AUnixDomainSocketThatCannotBeIsNamed) {
    const auto error_of = [](const UnixPath& path) -> std::string {
        try {
            Loop loop;
            Listener listener(loop, path, [](auto) {});
        } catch (const NetError& error) {
            return error.what();
        }
        return "no error";
    };
    const std::string longest = "/" + std::string(kMaxUnixPath, 'n');
    EXPECT_EQ(error_of({longest}),
              "cannot listen on unix:" + longest + ": a name of 108 bytes, limit 107");
    EXPECT_EQ(error_of({"/nowhere/at/all"}),
              "cannot listen on unix:/nowhere/at/all: No such file or directory");
    EXPECT_THROW(Client({longest}, 20ms), NetError);
    EXPECT_THROW(Client({"/nowhere/at/all"}, 20ms), NetError);
}

TEST(Net, DozingEndsWithThePeersFrameAndNeverWaitsForOneThatIsHere) {
    Server server;
    Client client("127.0.0.1", server.listener.port(), 5000ms);
    Connection& connection = server.accepted();
    connection.doze(1ms);  // nothing comes: it ends by itself
    client.send("(syn)");
    const auto start = Clock::now();
    connection.doze(60'000ms);
    EXPECT_EQ(server.frame(connection), "(syn)");
    client.send("(one)");
    client.send("(two)");
    EXPECT_EQ(server.frame(connection), "(one)");
    connection.doze(60'000ms);  // "(two)" has come, read or not
    EXPECT_EQ(server.frame(connection), "(two)");
    EXPECT_LT(Clock::now() - start, 60s) << "it slept on";
}

TEST(Net, WaitKeepsItsDeadlineWithNothingToDo) {
    Loop loop;
    const auto start = Clock::now();
    EXPECT_FALSE(loop.wait(start + 30ms, [] { return false; }));
    EXPECT_GE(Clock::now(), start + 30ms);
    EXPECT_TRUE(loop.wait(start, [] { return true; })) << "a deadline in the past still looks once";
}

TEST(Net, AsksAgainThoughNothingHappens) {
    Loop loop;
    const auto start = Clock::now();
    EXPECT_TRUE(loop.wait(start + 60s, [&] { return Clock::now() > start + 150ms; }));
    EXPECT_LT(Clock::now() - start, 30s) << "a signal's flag would not be seen";
}

}  // namespace
}  // namespace k3d::net
