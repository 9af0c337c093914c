// SPDX-License-Identifier: BSD-3-Clause
// Episode results as lines: what is written is read again, and what is not a result is named.
#include "common/episode/result.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace k3d::episode {
namespace {

Result sample() {
    Result r;
    r.game = "keepaway";
    r.seed = std::numeric_limits<std::uint64_t>::max();
    r.status = Status::Truncated;
    r.reason = "time_limit";
    r.hold_time_s = 300.02;
    r.attempts = 7;
    r.kicks = 6;
    r.passes_completed = 5;
    r.players = {{"left", 1, 2, 12.5, 0.25}, {"right", 2, 0, 0.1, 1.0 / 3.0}};
    r.metrics = {{"side_m", 10.0}, {"error_m", -1e-9}};
    r.state_hash = "0123456789abcdef";
    r.code_version = "abc";
    return r;
}

/// What from_line() says of the sample with another value at a JSON pointer; "" if it is content.
std::string fault(const char* pointer, const char* value) {
    auto line = nlohmann::ordered_json::parse(to_line(sample()));
    line[nlohmann::ordered_json::json_pointer(pointer)] = nlohmann::ordered_json::parse(value);
    try {
        from_line(line.dump());
    } catch (const ResultError& error) {
        return error.what();
    }
    return "";
}

TEST(Result, IsReadAsItWasWritten) {
    const std::string line = to_line(sample());
    const Result read = from_line(line);
    EXPECT_EQ(to_line(read), line);
    EXPECT_EQ(read.seed, sample().seed);
    EXPECT_EQ(read.status, Status::Truncated);
    EXPECT_EQ(read.attempts, 7);
    EXPECT_EQ(read.players.at(1).mean_speed, 1.0 / 3.0);
    EXPECT_EQ(read.metrics, sample().metrics);
}

TEST(Result, MayHaveNoAttemptsPlayersAndMetrics) {
    Result bare = sample();
    bare.attempts.reset();
    bare.players.clear();
    bare.metrics.clear();
    const Result read = from_line(to_line(bare));
    EXPECT_EQ(read.attempts, std::nullopt);
    EXPECT_TRUE(read.players.empty());
    EXPECT_TRUE(read.metrics.empty());
}

TEST(Result, AWholeNumberIsANumber) {
    EXPECT_EQ(fault("/hold_time_s", "300"), "");
    EXPECT_EQ(fault("/metrics/side_m", "10"), "");
}

TEST(Result, ValuesOfAnotherKindAreNamed) {
    const std::string whole = ", not a whole number of 32 bits";
    EXPECT_EQ(fault("/kicks", "3.7"), "episode result: kicks is 3.7" + whole);
    EXPECT_EQ(fault("/kicks", "true"), "episode result: kicks is true" + whole);
    EXPECT_EQ(fault("/kicks", "2147483648"), "episode result: kicks is 2147483648" + whole);
    EXPECT_EQ(fault("/attempts", "\"7\""), "episode result: attempts is \"7\"" + whole);
    EXPECT_EQ(fault("/players/0/unum", "null"), "episode result: unum is null" + whole);
    EXPECT_EQ(fault("/seed", "-1"),
              "episode result: seed is -1, not a whole number from 0 to 2^64 - 1");
    EXPECT_EQ(fault("/hold_time_s", "true"), "episode result: hold_time_s is true, not a number");
    EXPECT_EQ(fault("/metrics/side_m", "null"),
              "episode result: metrics.side_m is null, not a number");
    EXPECT_EQ(fault("/reason", "1"), "episode result: reason is 1, not a text");
    EXPECT_EQ(fault("/players", "{}"), "episode result: players is no list");
    EXPECT_EQ(fault("/players/1", "5"), "episode result: 5 is no object");
    EXPECT_EQ(fault("/metrics", "[1]"), "episode result: metrics is no object");
}

TEST(Result, OtherSchemasAndUnknownStatusAreNamed) {
    EXPECT_EQ(fault("/schema", "2"), "episode result: schema 2, this program reads 1");
    EXPECT_EQ(fault("/status", "\"won\""),
              "episode result: status 'won' is none of finished, truncated, diverged, agent_lost");
}

TEST(Result, WhatIsMissingIsNamed) {
    auto line = nlohmann::ordered_json::parse(to_line(sample()));
    for (const auto& [key, value] : line.items()) {
        auto rest = line;
        rest.erase(key);
        try {
            from_line(rest.dump());
            ADD_FAILURE() << key << " is not missed";
        } catch (const ResultError& error) {
            EXPECT_EQ(std::string(error.what()), "episode result: no " + key);
        }
    }
}

TEST(Result, WhatIsNoObjectIsRefused) {
    for (const char* line : {"", "{", "[]", "7", "{\"schema\":"}) {
        EXPECT_THROW(from_line(line), ResultError) << line;
    }
}

}  // namespace
}  // namespace k3d::episode
