// SPDX-License-Identifier: BSD-3-Clause
// Tests of telemetry: every line a JSON object with time and event; absolute frame; events.
#include "agent/action/telemetry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "agent/decision/keepaway/scene.h"

namespace k3d::agent::action {
namespace {

using nlohmann::json;

class TelemetryTest : public testing::Test {
  protected:
    TelemetryTest()
        : path_((std::filesystem::path(testing::TempDir()) /
                 ("k3d-telemetry-" + std::to_string(getpid()) + ".jsonl"))
                    .string()) {}
    ~TelemetryTest() override { std::filesystem::remove(path_); }

    std::vector<json> lines() const {
        std::ifstream file(path_);
        std::vector<json> all;
        for (std::string line; std::getline(file, line);) all.push_back(json::parse(line));
        return all;
    }
    std::vector<json> events(const std::string& event) const {
        std::vector<json> found;
        for (const json& line : lines()) {
            EXPECT_TRUE(line.at("time").is_number());
            if (line.at("event") == event) found.push_back(line);
        }
        return found;
    }

    std::string path_;
};

world::Beliefs seen_from(wire::Side side, double now) {
    world::Beliefs b = decision::test::scene(3, {{-1.0, 2.0}, radians(30.0)}, {0.5, -0.25}, now);
    b.game.side = side;
    b.ball.velocity = {1.0, 0.0};
    b.ball.finish = {1.25, -0.25};
    return b;
}

decision::Decision k1_at(Vec2 target) {
    decision::Decision d;
    d.account.role = "K1";
    d.account.skill = "position";
    d.account.target = target;
    d.account.taker_distance = 1.5;
    return d;
}

TEST_F(TelemetryTest, BeliefsAtTheirInterval) {
    Telemetry t(path_, "Reds", 0.2);
    for (int cycle = 0; cycle < 100; ++cycle)
        t.record(seen_from(wire::Side::Left, 10.0 + cycle * 0.02), {}, k1_at({4.0, 0.0}));
    ASSERT_EQ(events("start").size(), 1u);
    EXPECT_EQ(events("start")[0]["team"], "Reds");
    EXPECT_EQ(events("start")[0]["unum"], 3);
    const auto beliefs = events("belief");
    ASSERT_EQ(beliefs.size(), 10u);
    EXPECT_DOUBLE_EQ(beliefs[1]["time"], 10.2);
    EXPECT_DOUBLE_EQ(beliefs[0]["pose"]["x"], -1.0);
    EXPECT_DOUBLE_EQ(beliefs[0]["pose"]["yaw_deg"], 30.0);
    EXPECT_DOUBLE_EQ(beliefs[0]["ball"]["finish_x"], 1.25);
    EXPECT_DOUBLE_EQ(beliefs[0]["target"]["x"], 4.0);
    EXPECT_EQ(beliefs[0]["role"], "K1");
}

TEST_F(TelemetryTest, RightTeamIsTurnedToTheFieldFrame) {
    Telemetry t(path_, "Blues", 0.2);
    t.record(seen_from(wire::Side::Right, 10.0), {}, k1_at({4.0, 1.0}));
    const json belief = events("belief").at(0);
    EXPECT_DOUBLE_EQ(belief["pose"]["x"], 1.0);
    EXPECT_DOUBLE_EQ(belief["pose"]["y"], -2.0);
    EXPECT_DOUBLE_EQ(belief["pose"]["yaw_deg"], -150.0);
    EXPECT_DOUBLE_EQ(belief["ball"]["vx"], -1.0);
    EXPECT_DOUBLE_EQ(belief["target"]["y"], -1.0);
}

TEST_F(TelemetryTest, ScoredTargetsWhenAsked) {
    const std::vector<decision::Scored> scored{{{1.0, 2.0}, 0.5}, {{-3.0, 0.0}, 12.25}};
    decision::Decision d = k1_at({4.0, 1.0});
    d.account.scored = scored;
    {
        Telemetry t(path_, "Blues", 0.2);
        t.record(seen_from(wire::Side::Right, 10.0), {}, d);
    }
    EXPECT_FALSE(events("belief").at(0).contains("scored"));
    Telemetry t(path_, "Blues", 0.2, true);
    t.record(seen_from(wire::Side::Right, 10.0), {}, d);
    EXPECT_EQ(events("belief").at(0)["scored"], json::parse("[[-1.0,-2.0,0.5],[3.0,0.0,12.25]]"));
}

TEST_F(TelemetryTest, EventsAreWrittenInTheirCycle) {
    Telemetry t(path_, "Reds", 60.0);
    motion::State body;
    double now = 10.0;
    const auto step = [&](const std::string& role) {
        decision::Decision d = k1_at({4.0, 0.0});
        d.account.role = role;
        t.record(seen_from(wire::Side::Left, now), body, d);
        now += 0.02;
        body.kick_started = body.kick_done = false;
    };
    step("K3");
    body.kick_started = true;
    step("K1");
    body.kick_done = true;
    step("K1");
    body.upright = false;
    body.falls = 1;
    step("K1");
    body.upright = true;
    step("K1");
    ASSERT_EQ(events("kick_attempt").size(), 1u);
    EXPECT_DOUBLE_EQ(events("kick_attempt")[0]["time"], 10.02);
    EXPECT_DOUBLE_EQ(events("kick_attempt")[0]["ball"]["x"], 0.5);
    EXPECT_EQ(events("kick_end").size(), 1u);
    ASSERT_EQ(events("fall").size(), 1u);
    EXPECT_EQ(events("fall")[0]["falls"], 1);
    EXPECT_EQ(events("got_up").size(), 1u);
    ASSERT_EQ(events("role").size(), 2u);
    EXPECT_EQ(events("role")[1]["from"], "K3");
}

TEST_F(TelemetryTest, UnknownBallIsNullAndNothingBeforeTheSide) {
    Telemetry t(path_, "Reds", 0.2);
    t.record(seen_from(wire::Side::None, 9.0), {}, {});
    EXPECT_TRUE(lines().empty());
    world::Beliefs b = seen_from(wire::Side::Left, 10.0);
    b.ball = {};
    t.record(b, {}, {});
    EXPECT_TRUE(events("belief").at(0)["ball"].is_null());
    EXPECT_TRUE(events("belief").at(0)["target"].is_null());
}

TEST_F(TelemetryTest, WordsOfTheServerMayBeAnyBytes) {
    Telemetry t(path_, "Reds", 0.2);
    world::Beliefs b = seen_from(wire::Side::Left, 10.0);
    b.game.play_mode = "Play\xffOn\xfe";
    t.record(b, {}, {});
    EXPECT_EQ(events("belief").at(0)["mode"], "Play\uFFFDOn\uFFFD");
}

TEST(Telemetry, SaysWhichFileCannotBeWrittenAndWhy) {
    EXPECT_THAT(
        [] { Telemetry("/no/such/folder/t.jsonl", "Reds", 0.2); },
        testing::ThrowsMessage<std::invalid_argument>(
            "cannot write telemetry to /no/such/folder/t.jsonl: No such file or directory"));
    Telemetry full("/dev/full", "Reds", 0.2);
    EXPECT_THAT([&] { full.record(seen_from(wire::Side::Left, 10.0), {}, {}); },
                testing::ThrowsMessage<std::runtime_error>(
                    "cannot write telemetry to /dev/full: No space left on device"));
}

}  // namespace
}  // namespace k3d::agent::action
