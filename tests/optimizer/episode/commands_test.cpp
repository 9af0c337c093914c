// SPDX-License-Identifier: BSD-3-Clause
// Command lines of the programs of an episode.
#include "optimizer/episode/commands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace k3d::optimizer::episode {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Not;

/// The word after `flag`, "" if there is none.
std::string after(const std::vector<std::string>& words, const std::string& flag) {
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (words[i] == flag) return words[i + 1];
    }
    return "";
}

TEST(Commands, SeatsAreKeepersThenTakers) {
    spec::MatchSpec spec;
    spec.keepers = 2;
    spec.takers = 1;
    std::vector<std::string> names;
    for (const Seat& seat : seats(spec)) names.push_back(seat.name());
    EXPECT_THAT(names, ElementsAre("keeper 1", "keeper 2", "taker 1"));
}

TEST(Commands, TheServerHasSeedPortsAndResultFile) {
    spec::MatchSpec spec;
    spec.keepers = 4;
    spec.pace = "sync";
    spec.server_config = "s.toml";
    spec.settings = "server:keepaway.side=12 agent:x=1";
    const auto words = server_command(spec, {3, 77, 1}, "/f", -1);
    EXPECT_EQ(after(words, "--seed"), "77");
    EXPECT_EQ(after(words, "--pace"), "sync");
    EXPECT_EQ(after(words, "--keepers"), "4");
    EXPECT_EQ(after(words, "--agent-port"), "0");
    EXPECT_EQ(after(words, "--results"), "/f/result.jsonl");
    EXPECT_EQ(after(words, "--config"), "s.toml");
    EXPECT_EQ(after(words, "--set"), "keepaway.side=12");
    EXPECT_THAT(words, Not(Contains("--http")));
    EXPECT_THAT(words, Not(Contains("x=1")));
    EXPECT_EQ(after(server_command(spec, {}, "/f", 8080), "--http"), "8080");
}

TEST(Commands, RolesDecideWhatAnAgentIsTold) {
    spec::MatchSpec spec;
    spec.keeper_policy = "still";
    spec.taker = "greedy_random";
    spec.keepers = 4;
    spec.takers = 3;
    const auto keeper = agent_command(spec, {0, 9, 1}, "/f", {true, 2}, 4321);
    EXPECT_EQ(after(keeper, "--port"), "4321");
    EXPECT_EQ(after(keeper, "--unum"), "2");
    EXPECT_EQ(after(keeper, "--team"), "Keepers");
    EXPECT_EQ(after(keeper, "--role"), "keeper");
    EXPECT_EQ(after(keeper, "--keeper-policy"), "still");
    EXPECT_EQ(after(keeper, "--telemetry"), "/f/keeper-2.telemetry.jsonl");
    EXPECT_EQ(after(keeper, "--seed"), "9");
    EXPECT_EQ(after(keeper, "--keepers"), "4");
    EXPECT_THAT(keeper, Not(Contains("--takers"))) << "the server's alone";
    const auto taker = agent_command(spec, {0, 9, 1}, "/f", {false, 1}, 4321);
    EXPECT_EQ(after(taker, "--team"), "Takers");
    EXPECT_EQ(after(taker, "--taker"), "greedy_random");
    EXPECT_THAT(taker, Not(Contains("--keeper-policy")));
    EXPECT_THAT(taker, Not(Contains("--telemetry")));
}

TEST(Commands, OurAgentsTakeTheServersUnixDomainSocketWhereItListens) {
    const spec::MatchSpec spec;
    EXPECT_EQ(after(server_command(spec, {}, "/f", -1), "--agent-socket"), "/f/agents");
    EXPECT_THAT(agent_command(spec, {}, "/f", {true, 1}, 9), Not(Contains("--socket")));
    EXPECT_EQ(after(agent_command(spec, {}, "/f", {true, 1}, 9, "/f/agents"), "--socket"), "/f/agents");
    const std::string deep = "/" + std::string(101, 'd');
    EXPECT_EQ(agent_socket(deep), "") << "a longer name than such sockets can have";
    EXPECT_THAT(server_command(spec, {}, deep, -1), Not(Contains("--agent-socket")));
}

TEST(Commands, AForeignProgramIsStartedAsTheUserWroteIt) {
    spec::MatchSpec spec;
    spec.taker_command = "./theirs {host} {port} {unum} {team}";
    EXPECT_THAT(agent_command(spec, {}, "/f", {false, 2}, 99),
                ElementsAre("./theirs", "127.0.0.1", "99", "2", "Takers"));
    EXPECT_TRUE(is_foreign(spec, {false, 1}));
    EXPECT_FALSE(is_foreign(spec, {true, 1}));
}

std::vector<std::string> names(const std::vector<AgentProcess>& processes) {
    std::vector<std::string> out;
    for (const AgentProcess& process : processes) out.push_back(process.name);
    return out;
}

TEST(Commands, EverySeatHasAProcessUnlessOursShareOne) {
    spec::MatchSpec spec;
    const auto apart = agent_processes(spec, {}, "/f", 99, "");
    EXPECT_THAT(names(apart),
                ElementsAre("keeper 1", "keeper 2", "keeper 3", "taker 1", "taker 2"));
    EXPECT_EQ(apart[3].command, agent_command(spec, {}, "/f", {false, 1}, 99));

    spec.one_process = true;
    const auto shared = agent_processes(spec, {}, "/f", 99, "");
    ASSERT_THAT(names(shared), ElementsAre("agents"));
    std::vector<std::string> all;
    for (const AgentProcess& process : apart) {
        if (!all.empty()) all.emplace_back("--and");
        all.insert(all.end(), process.command.begin() + (all.empty() ? 0 : 1), process.command.end());
    }
    EXPECT_EQ(shared[0].command, all) << "the program's name once, each agent's own words";

    spec.keeper_command = "./theirs {unum}";
    const auto foreign = agent_processes(spec, {}, "/f", 99, "");
    EXPECT_THAT(names(foreign), ElementsAre("keeper 1", "keeper 2", "keeper 3", "agents"));
    EXPECT_TRUE(foreign[0].foreign);
    EXPECT_FALSE(foreign[3].foreign);
}

}  // namespace
}  // namespace k3d::optimizer::episode
