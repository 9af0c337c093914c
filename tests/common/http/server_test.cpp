// SPDX-License-Identifier: BSD-3-Clause
// Tests for common/http/server.cpp: what it answers, and that no peer harms another.
#include "common/http/server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "common/http/raw_peer.h"
#include "common/http/temporary_folder.h"

namespace k3d::http {
namespace {

using namespace std::chrono_literals;
using test::RawPeer;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kBigFile(3'000'000, 'b');

class ServerTest : public testing::Test {
  protected:
    ServerTest() {
        folder_.write("index.html", "<p>page</p>");
        folder_.write("big.js", kBigFile);
    }
    Server& start(Limits limits = {}) {
        Server::Options options;
        options.folder = folder_.path().string();
        options.limits = limits;
        server_ = std::make_unique<Server>(loop_, options, [this](std::unique_ptr<Socket> socket) {
            sockets_.push_back(std::move(socket));
        });
        return *server_;
    }
    std::string ask(RawPeer& peer, const std::string& request) {
        peer.send(request);
        return peer.answer(loop_);
    }
    std::string ask(const std::string& request) {
        RawPeer peer(server_->port());
        return ask(peer, request);
    }
    /// What anybody else would find after a bad peer: the page.
    void expect_serving() {
        EXPECT_THAT(ask("GET / HTTP/1.1\r\nHost: x\r\n\r\n"), HasSubstr("<p>page</p>"));
    }

    test::TemporaryFolder folder_;
    net::Loop loop_;
    std::vector<std::unique_ptr<Socket>> sockets_;
    std::unique_ptr<Server> server_;
};

TEST_F(ServerTest, ServesFilesOverOneConnection) {
    RawPeer peer(start().port());
    const std::string page = ask(peer, "GET / HTTP/1.1\r\nHost: x\r\n\r\n");
    EXPECT_THAT(page, StartsWith("HTTP/1.1 200 OK\r\n"));
    EXPECT_THAT(page, HasSubstr("Content-Type: text/html; charset=utf-8\r\n"));
    EXPECT_THAT(page, testing::EndsWith("\r\n\r\n<p>page</p>"));
    const std::string big = ask(peer, "GET /big.js HTTP/1.1\r\nHost: x\r\n\r\n");
    EXPECT_THAT(big, HasSubstr("Content-Type: text/javascript; charset=utf-8\r\n"));
    EXPECT_EQ(big.substr(big.find("\r\n\r\n") + 4), kBigFile);
    peer.send("HEAD /big.js HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n");
    EXPECT_TRUE(peer.until_closed(loop_));
    EXPECT_THAT(peer.received(), HasSubstr("Content-Length: 3000000\r\n"));
    EXPECT_THAT(peer.received(), testing::EndsWith("\r\n\r\n"));
}

TEST_F(ServerTest, SaysWhatIsWrong) {
    start();
    EXPECT_THAT(ask("GET /none HTTP/1.1\r\nHost: x\r\n\r\n"), StartsWith("HTTP/1.1 404 "));
    EXPECT_THAT(ask("GET /../server_test HTTP/1.1\r\nHost: x\r\n\r\n"),
                StartsWith("HTTP/1.1 404 "));
    EXPECT_THAT(ask("GET /%zz HTTP/1.1\r\nHost: x\r\n\r\n"), StartsWith("HTTP/1.1 400 "));
    EXPECT_THAT(ask("GET nonsense HTTP/1.1\r\nHost: x\r\n\r\n"), StartsWith("HTTP/1.1 400 "));
    EXPECT_THAT(ask("GET /stream HTTP/1.1\r\nHost: x\r\n\r\n"), StartsWith("HTTP/1.1 426 "));
    const std::string post = ask("POST / HTTP/1.1\r\nHost: x\r\nContent-Length: 5\r\n\r\nhello");
    EXPECT_THAT(post, StartsWith("HTTP/1.1 405 "));
    EXPECT_THAT(post, HasSubstr("Allow: GET, HEAD\r\n"));
    EXPECT_THAT(post, HasSubstr("Connection: close\r\n"));  // its body is not a request
}

TEST_F(ServerTest, GarbageHarmsNobody) {
    start();
    RawPeer watcher(server_->port());
    ASSERT_TRUE(watcher.open_socket(loop_));
    std::string noise;
    for (int i = 0; i < 20'000; ++i) noise += static_cast<char>(i * 7919 % 251);
    for (const std::string& bytes :
         {noise, std::string("\0\0\0\5(syn)", 9), std::string("\xff\xff\xff\xff"),
          std::string("GET / HTTP/9.9\r\n\r\n"), std::string("\r\n\r\n\r\n"),
          std::string("GET / HTTP/1.1\r\nno colon\r\n\r\n"), std::string("\x16\x03\x01\x02", 4),
          "GET / HTTP/1.1\r\nHost: " + std::string(9000, 'h') + "\r\n\r\n"}) {
        RawPeer peer(server_->port());
        peer.send(bytes);
        loop_.poll();
        expect_serving();
    }
    ASSERT_EQ(sockets_.size(), 1u);
    EXPECT_TRUE(sockets_[0]->send(Socket::Kind::Text, "still here"));
    std::string message;
    EXPECT_TRUE(watcher.until(loop_, [&] { return watcher.cut_message(message); }));
    EXPECT_EQ(message, "still here");
}

TEST_F(ServerTest, GarbageIsAnsweredAndCutOff) {
    start();
    RawPeer garbage(server_->port());
    garbage.send("(scene rsg/agent/nao/nao_hetero.rsg 0)\r\n\r\n");
    EXPECT_TRUE(garbage.until_closed(loop_));
    EXPECT_THAT(garbage.received(), StartsWith("HTTP/1.1 400 "));
    RawPeer endless(server_->port());
    endless.send("GET / HTTP/1.1\r\nX: " + std::string(20'000, 'x'));
    EXPECT_TRUE(endless.until_closed(loop_));
    EXPECT_THAT(endless.received(), StartsWith("HTTP/1.1 431 "));
}

TEST_F(ServerTest, SilentAndSlowPeersAreCutOff) {
    Limits limits;
    limits.request = 50ms;
    start(limits);
    RawPeer silent(server_->port());
    RawPeer half(server_->port());
    half.send("GET / HTT");
    RawPeer idle(server_->port());
    EXPECT_THAT(ask(idle, "GET / HTTP/1.1\r\nHost: x\r\n\r\n"), StartsWith("HTTP/1.1 200 "));
    EXPECT_TRUE(silent.until_closed(loop_));
    EXPECT_TRUE(half.until_closed(loop_));
    EXPECT_TRUE(idle.until_closed(loop_));
    // Dripping one byte after another does not move the deadline.
    RawPeer drip(server_->port());
    EXPECT_TRUE(drip.until(loop_, [&] {
        drip.send("G");
        return drip.closed();
    }));
    EXPECT_EQ(server_->connections(), 0u);
}

TEST_F(ServerTest, APeerThatTakesNoFileIsCutOff) {
    Limits limits;
    limits.answer = 50ms;
    start(limits);
    folder_.write("huge.bin", "");  // more than the kernel would hold for the peer
    std::filesystem::resize_file(folder_.path() / "huge.bin", 64'000'000);
    RawPeer stuck(server_->port(), 4096);
    stuck.send("GET /huge.bin HTTP/1.1\r\nHost: x\r\n\r\n");
    EXPECT_TRUE(stuck.until(loop_, [&] { return !stuck.received().empty(); }));
    EXPECT_TRUE(loop_.wait(net::Clock::now() + test::kPatience,
                           [&] { return server_->connections() == 0; }));
    EXPECT_TRUE(stuck.until_closed(loop_));
    EXPECT_LT(stuck.received().size(), 64'000'000u);
    expect_serving();
}

TEST_F(ServerTest, TurnsAwayWhoIsTooMany) {
    Limits limits;
    limits.connections = 2;
    start(limits);
    RawPeer first(server_->port());
    RawPeer second(server_->port());
    ASSERT_TRUE(second.open_socket(loop_));
    RawPeer third(server_->port());
    EXPECT_TRUE(third.until_closed(loop_));
    EXPECT_THAT(third.received(), StartsWith("HTTP/1.1 503 "));
    sockets_.clear();
    EXPECT_TRUE(second.until_closed(loop_));
    expect_serving();
}

TEST_F(ServerTest, AFloodOfRequestsMustReconnect) {
    start();
    RawPeer peer(server_->port());
    std::string flood;
    for (int i = 0; i < 1000; ++i) flood += "HEAD / HTTP/1.1\r\nHost: x\r\n\r\n";
    peer.send(flood);
    EXPECT_TRUE(peer.until_closed(loop_));
    std::size_t answers = 0;
    for (std::size_t at = 0; (at = peer.received().find("200 OK", at)) != std::string::npos; ++at) {
        ++answers;
    }
    EXPECT_EQ(answers, 200u);
}

TEST_F(ServerTest, TwoPagesAndASlowOne) {
    start();
    RawPeer quick(server_->port());
    RawPeer slow(server_->port(), 4096);
    ASSERT_TRUE(quick.open_socket(loop_));
    ASSERT_TRUE(slow.open_socket(loop_));
    ASSERT_EQ(sockets_.size(), 2u);
    // The slow page takes nothing: what it is behind stays bounded, and the quick one misses none.
    constexpr int kMessages = 400;
    int dropped = 0;
    for (int i = 0; i < kMessages; ++i) {
        const std::string message = std::to_string(i) + std::string(10'000, '.');
        ASSERT_TRUE(sockets_[0]->send(Socket::Kind::Text, message));
        if (!sockets_[1]->send(Socket::Kind::Text, message)) ++dropped;
        std::string got;
        ASSERT_TRUE(quick.until(loop_, [&] { return quick.cut_message(got); }));
        ASSERT_EQ(got, message);
        // Taken by the peer, but our side may still have to hear of it.
        ASSERT_TRUE(quick.until(loop_, [&] { return sockets_[0]->ready(); }));
    }
    EXPECT_GT(dropped, kMessages / 2);
    EXPECT_FALSE(sockets_[1]->closed());
    // It catches up with whole messages, in order.
    std::string got;
    int last = -1;
    EXPECT_TRUE(slow.until(loop_, [&] {
        while (slow.cut_message(got)) {
            EXPECT_EQ(got.size() - std::to_string(std::stoi(got)).size(), 10'000u);
            EXPECT_GT(std::stoi(got), last);
            last = std::stoi(got);
        }
        return sockets_[1]->ready() && slow.received().empty();
    }));
    EXPECT_TRUE(sockets_[1]->send(Socket::Kind::Text, "999 now"));
    EXPECT_TRUE(slow.until(loop_, [&] { return slow.cut_message(got); }));
    EXPECT_EQ(got, "999 now");
}

TEST_F(ServerTest, EndsAreNoticedOnBothSides) {
    start();
    auto leaver = std::make_unique<RawPeer>(server_->port());
    RawPeer talker(server_->port());
    RawPeer stayer(server_->port());
    ASSERT_TRUE(leaver->open_socket(loop_));
    ASSERT_TRUE(talker.open_socket(loop_));
    ASSERT_TRUE(stayer.open_socket(loop_));
    leaver.reset();
    talker.send(std::string("\x81\x82\0\0\0\0hi", 8));  // a page has nothing to say
    EXPECT_TRUE(loop_.wait(net::Clock::now() + test::kPatience,
                           [&] { return sockets_[0]->closed() && sockets_[1]->closed(); }));
    EXPECT_FALSE(sockets_[0]->send(Socket::Kind::Text, "to nobody"));
    EXPECT_TRUE(talker.until_closed(loop_));
    EXPECT_FALSE(sockets_[2]->closed());
    server_.reset();
    EXPECT_TRUE(stayer.until_closed(loop_));
    EXPECT_TRUE(sockets_[2]->closed());  // handles outlive the server
}

TEST_F(ServerTest, ABusyPortIsNamed) {
    const std::string port = std::to_string(start().port());
    Server::Options options;
    options.folder = folder_.path().string();
    options.port = server_->port();
    const auto message = [&] {
        try {
            Server second(loop_, options, [](std::unique_ptr<Socket>) {});
        } catch (const net::NetError& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    EXPECT_EQ(message(), "cannot listen on 127.0.0.1:" + port + ": Address already in use");
    options.address = "somewhere";
    EXPECT_EQ(message(), "cannot listen on somewhere:" + port + ": not an IP address");
}

TEST_F(ServerTest, TheNextServerTakesThePortAtOnce) {
    start();
    RawPeer peer(server_->port());
    ASSERT_TRUE(peer.open_socket(loop_));
    Server::Options options;
    options.folder = folder_.path().string();
    options.port = server_->port();
    server_.reset();
    server_ = std::make_unique<Server>(loop_, options, [](std::unique_ptr<Socket>) {});
    expect_serving();
}

}  // namespace
}  // namespace k3d::http
