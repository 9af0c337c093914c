// SPDX-License-Identifier: BSD-3-Clause
// A run's specification: what it refuses, and that its printed form loads again.
#include "optimizer/spec/match_spec.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "common/config/config.h"

namespace k3d::optimizer::spec {
namespace {

using testing::HasSubstr;

std::string refusal(const MatchSpec& spec) {
    try {
        check(spec);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "none";
}

TEST(MatchSpec, DefaultsAreThePapersGame) {
    const MatchSpec spec;
    EXPECT_EQ(refusal(spec), "none");
    EXPECT_EQ(spec.keepers, 3);
    EXPECT_EQ(spec.takers, 2);
}

TEST(MatchSpec, PrintedItLoadsAgain) {
    MatchSpec spec;
    spec.episodes = 20;
    spec.seed = std::numeric_limits<std::uint64_t>::max() - 30;
    spec.keeper_command = "sh -c 'exec \"x\" {port}'";
    spec.deadline_s = 2.5;
    const std::string text = config::print(config::describing(spec));
    MatchSpec again;
    config::load_text(config::describing(again), text, "printed");
    EXPECT_EQ(config::print(config::describing(again)), text);
    EXPECT_EQ(again.keeper_command, spec.keeper_command);
    EXPECT_EQ(again.seed, spec.seed);
}

TEST(MatchSpec, ValuesThatCannotBeAreNamed) {
    MatchSpec spec;
    spec.seed = std::numeric_limits<std::uint64_t>::max();
    EXPECT_EQ(refusal(spec), "none");
    spec.episodes = 2;
    EXPECT_THAT(refusal(spec), HasSubstr("seed 18446744073709551615 is too large"));
    spec = {};
    spec.agent_config = "/nowhere/agent.toml";
    EXPECT_EQ(refusal(spec), "agent_config: no such file: /nowhere/agent.toml");
    spec = {};
    spec.taker_command = "agent {prot}";
    EXPECT_THAT(refusal(spec), HasSubstr("taker_command 'agent {prot}': {prot} is none of"));
    spec = {};
    spec.keeper_command = "  ";
    EXPECT_THAT(refusal(spec), HasSubstr("it is blank"));
    spec = {};
    spec.settings = "server:side";
    EXPECT_THAT(refusal(spec), HasSubstr("'server:side'"));
}

TEST(MatchSpec, FieldsHaveRanges) {
    MatchSpec spec;
    const auto describe = config::describing(spec);
    EXPECT_THROW(config::set(describe, "keepers", "12"), config::ConfigError);
    EXPECT_THROW(config::set(describe, "keepers", "0"), config::ConfigError);
    EXPECT_THROW(config::set(describe, "jobs", "two"), config::ConfigError);
    EXPECT_THROW(config::set(describe, "taker", "lazy"), config::ConfigError);
    EXPECT_THROW(config::set(describe, "http_port", "65536"), config::ConfigError);
}

}  // namespace
}  // namespace k3d::optimizer::spec
