// SPDX-License-Identifier: BSD-3-Clause
// Tests of the reply frame: joints of the type only, turns to speak, beams, `(syn)` last.
#include "agent/action/compose.h"

#include <gtest/gtest.h>

#include <string>

#include "agent/decision/keepaway/scene.h"
#include "agent/talk/slots.h"

namespace k3d::agent::action {
namespace {

wire::Commands at(double now, const std::string& mode, Limits limits, bool talks = true) {
    world::Beliefs b = decision::test::scene(2, {}, Vec2::Zero(), now);
    b.game.play_mode = mode;
    decision::Decision d;
    if (talks) {
        d.say.emplace();
        d.say->unum = 2;
    }
    nao::JointArray rates{};
    rates[nao::index(nao::JointId::HeadYaw)] = 0.5;
    wire::Commands commands;
    commands.say = {"left from before"};
    std::string unsaid;
    compose(nao::model(0), rates, d, b, limits, unsaid, commands);
    return commands;
}

TEST(Compose, AllJointsOfTheTypeAndSynLast) {
    const wire::Commands c = at(10.0, "PlayOn", {3, false}, false);
    int joints = 0;
    for (const auto& rate : c.joint_rates) joints += rate.has_value();
    EXPECT_EQ(joints, 22);
    EXPECT_EQ(c.joint_rates[nao::index(nao::JointId::HeadYaw)], 0.5);
    std::string text;
    wire::encode(c, text);
    EXPECT_EQ(text.substr(text.size() - 5), "(syn)");
}

TEST(Compose, SpeaksInItsTurnOnly) {
    int said = 0;
    for (int cycle = 0; cycle < 60; ++cycle) {
        const auto c = at(cycle * 0.02, "PlayOn", {3, false});
        EXPECT_EQ(!c.say.empty(), cycle % 6 == 2);
        said += static_cast<int>(c.say.size());
        EXPECT_TRUE(at(cycle * 0.02, "PlayOn", {3, false}, false).say.empty());
    }
    EXPECT_EQ(said, 10);
}

TEST(Compose, BeamsOnlyBeforeKickOffAndIfAsked) {
    EXPECT_FALSE(at(1.0, "BeforeKickOff", {3, false}).beam);
    EXPECT_FALSE(at(1.0, "PlayOn", {3, true}).beam);
    ASSERT_TRUE(at(1.0, "BeforeKickOff", {3, true}).beam);
    for (int unum = 1; unum <= 11; ++unum) {
        EXPECT_LT(kick_off_beam(unum).x, -0.5);
        EXPECT_LT(std::abs(kick_off_beam(unum).y), 9.5);
        for (int other = 1; other < unum; ++other)
            EXPECT_GT(std::hypot(kick_off_beam(unum).x - kick_off_beam(other).x,
                                 kick_off_beam(unum).y - kick_off_beam(other).y),
                      1.0);
    }
}

}  // namespace
}  // namespace k3d::agent::action
