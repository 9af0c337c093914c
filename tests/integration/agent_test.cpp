// SPDX-License-Identifier: BSD-3-Clause
// k3d-agent as a program: what is wrong with its flags is named before anybody hears of it, and who
// gets no seat says which.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "integration/server_process.h"

namespace k3d::testing {
namespace {

using ::testing::HasSubstr;
using Flags = std::vector<std::string>;

std::pair<int, std::string> run_agent(const Flags& flags) {
    return run_to_end("k3d-agent", flags);
}

TEST(Agent, WhatIsWrongIsNamedBeforeItConnects) {
    const std::vector<std::pair<Flags, std::string>> cases{
        {{"--team", "a b"}, "'a b' has a blank"},
        {{"--unum", "12"}, "12"},
        {{"--set", "keper.x=1"}, "keper.x"},
        {{"--keeper-policy", "handcoed"}, "keeper.policy \"handcoed\" is none of handcoded"},
        {{"--telemetry", "/no/such/x"}, "cannot write telemetry to /no/such/x: No such file"},
        {{"--and", "--unum", "12"}, "12"},
        {{"--and", "--set", "keper.x=1"}, "keper.x"},
        {{"--and", "--keeper-policy", "handcoed"}, "keeper.policy \"handcoed\""},
        {{"--and", "--log-level", "off"}, "--log-level is of the whole process"},
    };
    const Flags nobody_there{"--port", "1", "--patience-s", "0.1"};
    EXPECT_EQ(run_agent(nobody_there).first, 1);
    for (const auto& [wrong, says] : cases) {
        Flags flags = nobody_there;
        flags.insert(flags.end(), wrong.begin(), wrong.end());
        const auto [code, text] = run_agent(flags);
        EXPECT_EQ(code, 2) << "1: it has tried to connect. " << text;
        EXPECT_THAT(text, HasSubstr(says));
    }
}

TEST(Agent, PrintsTheConfigurationOfWhoeverIsAsked) {
    const auto [code, text] = run_agent({"--and", "--role", "taker", "--print-config"});
    EXPECT_EQ(code, 0);
    EXPECT_THAT(text, HasSubstr("role = \"taker\""));
}

TEST(Agent, WhoGetsNoSeatSaysWhich) {
    const ServerProcess server({});  // in real time: it waits for nobody
    WireAgent first(server);
    first.join(1, "Reds");
    const auto [code, text] =
        run_agent({"--port", std::to_string(server.agent_port()), "--team", "Reds", "--unum", "1"});
    EXPECT_EQ(code, 1);
    EXPECT_THAT(text, HasSubstr("the server gave no place to number 1 of team Reds"));
}

}  // namespace
}  // namespace k3d::testing
