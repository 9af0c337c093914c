// SPDX-License-Identifier: BSD-3-Clause
// What must not hurt: bad flags, bad bytes, bad teams, agents that hang or die. Each gives one
// clear line, and nobody else notices.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "common/episode/result.h"
#include "common/random/stream.h"
#include "integration/raw_socket.h"
#include "integration/server_process.h"

namespace k3d::testing {
namespace {

/// Runs the server with flags that must be refused; returns its exit code and what it printed.
std::pair<int, std::string> refused(const std::vector<std::string>& flags) {
    return run_to_end("k3d-server", flags);
}

TEST(BadFlags, EachNamesWhatIsWrong) {
    struct Case {
        std::vector<std::string> flags;
        std::string says;
    };
    const std::vector<Case> cases{
        {{"--warp"}, "--warp"},
        {{"--pace", "slow"}, "slow"},
        {{"--seed", "x"}, "x"},
        {{"--agent-port", "70000"}, "70000"},
        {{"--config", "/nonexistent/k3d.toml"}, "/nonexistent/k3d.toml"},
        {{"--set", "keepaway.sied=9"}, "keepaway.sied"},
        {{"--set", "keepaway.side=99"}, "99"},
        {{"--set", "keepaway.side"}, "keepaway.side"},
        {{"--log-level", "loud"}, "loud"},
    };
    for (const Case& c : cases) {
        const auto [code, text] = refused(c.flags);
        EXPECT_EQ(code, 2) << c.flags.front();
        EXPECT_NE(text.find(c.says), std::string::npos) << text;
    }
}

TEST(BadFlags, BusyPortIsNamed) {
    ServerProcess first({});
    const std::string port = std::to_string(first.agent_port());
    const auto [code, text] = refused({"--agent-port", port, "--server-port", "0"});
    EXPECT_EQ(code, 1);
    EXPECT_NE(text.find("127.0.0.1:" + port), std::string::npos) << text;
}

TEST(BadFlags, ConfigFileFaultsCarryFileAndLine) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("k3d-bad-" + std::to_string(getpid()) + ".toml");
    std::ofstream(file) << "seed = 4\n[keepaway]\nsides = 9.0\n";
    const auto [code, text] = refused({"--config", file.string()});
    std::filesystem::remove(file);
    EXPECT_EQ(code, 2);
    EXPECT_NE(text.find(file.string() + ":3"), std::string::npos) << text;
    EXPECT_NE(text.find("keepaway.side"), std::string::npos) << "the nearest key: " << text;
}

TEST(BadBytes, OtherAgentsGoOnUndisturbed) {
    ServerProcess server({"--pace", "sync"});
    WireAgent good(server);
    good.join(1, "Reds");
    RandomStream random(7, "test", "garbage");
    for (const std::uint16_t port : {server.agent_port(), server.trainer_port()}) {
        RawSocket huge(port);
        huge.write(std::string("\xff\xff\xff\xff", 4) + "rest");
        RawSocket half(port);
        half.write(std::string("\0\0\1\0(he1", 8));  // 256 bytes announced, 4 sent
        RawSocket noise(port);
        for (int i = 0; i < 50; ++i) {
            std::string bytes;
            for (int k = random.below(200); k > 0; --k) {
                bytes += static_cast<char>(random.below(256));
            }
            std::string frame;
            wire::append_frame(bytes, frame);
            noise.write(frame);
        }
        double time = good.step().time;
        for (int i = 0; i < 50; ++i) {
            const double next = good.step("(he1 0.1)").time;
            EXPECT_NEAR(next - time, 0.02, 1e-9);
            time = next;
        }
        EXPECT_TRUE(huge.closed_by_peer(kPatience)) << "4 GB announced";
    }
}

TEST(BadTeams, RefusedAgentsStayConnectedWithoutATeam) {
    // In the lobby each agent is answered by itself, however many others there are.
    ServerProcess server({"--game", "keepaway", "--pace", "fast"});
    const auto joins = [&](WireAgent& agent, const std::string& unum, const std::string& team) {
        wire::Percepts percepts;
        agent.send("(scene rsg/agent/nao/nao.rsg)(syn)");
        EXPECT_TRUE(agent.receive(percepts));
        percepts = agent.step("(init (unum " + unum + ")(teamname " + team + "))");
        bool told = percepts.game->unum.has_value();
        for (int i = 0; i < 3; ++i) told = told || agent.step().game->unum.has_value();
        return told;
    };
    WireAgent keeper(server), high(server), low(server), same(server), taker(server), third(server);
    EXPECT_TRUE(joins(keeper, "1", "Reds"));
    EXPECT_FALSE(joins(high, "99", "Reds"));
    EXPECT_FALSE(joins(low, "-3", "Reds"));
    EXPECT_FALSE(joins(same, "1", "Reds"));
    EXPECT_TRUE(joins(taker, "0", "Blues"));
    EXPECT_FALSE(joins(third, "1", "Greens"));
    const std::string log = server.log();
    for (const char* line : {"number 99", "number -3", "number 1 of team 'Reds' is taken",
                             "third team 'Greens'"}) {
        EXPECT_NE(log.find(line), std::string::npos) << line;
    }
}

/// One keeper against one taker, played by hand up to kick-off.
class Duel : public ::testing::Test {
  protected:
    Duel()
        : results_(std::filesystem::temp_directory_path() /
                   ("k3d-duel-" + std::to_string(getpid()) + ".jsonl")) {
        std::filesystem::remove(results_);
    }
    ~Duel() override { std::filesystem::remove(results_); }
    std::vector<std::string> flags(std::vector<std::string> more) const {
        std::vector<std::string> all{"--game",    "keepaway", "--pace",    "fast",
                                     "--keepers", "1",        "--takers",  "1",
                                     "--results", results_.string()};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    episode::Result result() const {
        std::ifstream file(results_);
        std::string line;
        std::getline(file, line);
        return episode::from_line(line);
    }
    std::filesystem::path results_;
};

void both_join(WireAgent& keeper, WireAgent& taker) {
    keeper.send("(scene rsg/agent/nao/nao.rsg)(syn)");
    taker.send("(scene rsg/agent/nao/nao.rsg)(syn)");
    wire::Percepts percepts;
    ASSERT_TRUE(keeper.receive(percepts));
    ASSERT_TRUE(taker.receive(percepts));
    keeper.send("(init (unum 1)(teamname Keepers))(syn)");
    taker.send("(init (unum 1)(teamname Takers))(syn)");
}

TEST_F(Duel, HungAgentEndsTheEpisodeAsAgentLost) {
    // We play the keeper, too: it must not be late, whatever else the machine has to do.
    ServerProcess server(flags({"--hung-agent-s", "5", "--left-team", "Keepers"}));
    WireAgent keeper(server);
    WireAgent taker(server);
    both_join(keeper, taker);
    wire::Percepts percepts;
    // The taker answers a while and then no more, with its connection open.
    for (int i = 0; i < 40; ++i) {
        ASSERT_TRUE(keeper.receive(percepts));
        ASSERT_TRUE(taker.receive(percepts));
        keeper.send("(syn)");
        taker.send("(syn)");
    }
    while (keeper.receive(percepts)) keeper.send("(syn)");
    const auto exit = server.child().wait(kPatience);
    ASSERT_TRUE(exit);
    EXPECT_EQ(exit->code, 3);
    EXPECT_EQ(result().status, episode::Status::AgentLost);
    EXPECT_EQ(result().reason, "right.1: hung");
}

TEST_F(Duel, DyingAgentEndsTheEpisodeAsAgentLost) {
    ServerProcess server(flags({"--left-team", "Keepers"}));
    WireAgent keeper(server);
    wire::Percepts percepts;
    {
        WireAgent taker(server);
        both_join(keeper, taker);
        for (int i = 0; i < 40; ++i) {
            ASSERT_TRUE(keeper.receive(percepts));
            ASSERT_TRUE(taker.receive(percepts));
            keeper.send("(syn)");
            taker.send("(syn)");
        }
    }
    while (keeper.receive(percepts)) keeper.send("(syn)");
    const auto exit = server.child().wait(kPatience);
    ASSERT_TRUE(exit);
    EXPECT_EQ(exit->code, 3);
    EXPECT_EQ(result().status, episode::Status::AgentLost);
    EXPECT_EQ(result().reason.rfind("right.1: ", 0), 0U) << result().reason;
}

TEST_F(Duel, ALobbyThatStaysEmptyNamesTheFreeSeats) {
    ServerProcess server(flags({"--lobby-s", "1"}));
    const auto exit = server.child().wait(kPatience);
    ASSERT_TRUE(exit);
    EXPECT_EQ(exit->code, 3);
    EXPECT_NE(server.log().find("waiting for left 1, right 1"), std::string::npos) << server.log();
}

}  // namespace
}  // namespace k3d::testing
