// SPDX-License-Identifier: BSD-3-Clause
// Command frames as agents in the wild write them, faults, and round trips.
#include "common/wire/commands.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/common/wire/gen.h"

namespace k3d::wire {
namespace {

using nao::JointId;

std::optional<double> rate(const Commands& commands, JointId id) {
    return commands.joint_rates[nao::index(id)];
}

TEST(CommandsDecode, StartUpFrames) {
    Commands commands;
    EXPECT_EQ(decode("(scene rsg/agent/nao/nao_hetero.rsg 3)(syn)", commands), 0);
    ASSERT_TRUE(commands.scene);
    EXPECT_EQ(commands.scene->file, "rsg/agent/nao/nao_hetero.rsg");
    EXPECT_EQ(commands.scene->arguments, std::vector<std::string>{"3"});
    EXPECT_TRUE(commands.syn);

    Commands init;
    EXPECT_EQ(decode("(init (unum 3) (teamname Reds))", init), 0);
    EXPECT_EQ(init.init->unum, 3);
    EXPECT_EQ(init.init->team, "Reds");
    EXPECT_FALSE(init.syn);

    Commands anyone;
    EXPECT_EQ(decode("(init)", anyone), 0);
    EXPECT_EQ(anyone.init->unum, 0);
    EXPECT_EQ(anyone.init->team, "");
}

TEST(CommandsDecode, JointsWithExponentsAndAllOthers) {
    Commands commands;
    EXPECT_EQ(decode("(he1 5.76)(rle4 -2.7703)(lle7 1e-05)(beam -6 0.5 -90)(say a;b\")(pass)(syn)",
                     commands),
              0);
    EXPECT_EQ(rate(commands, JointId::HeadYaw), 5.76);
    EXPECT_EQ(rate(commands, JointId::RKneePitch), -2.7703);
    EXPECT_EQ(rate(commands, JointId::LToe), 1e-05);
    EXPECT_FALSE(rate(commands, JointId::RToe));
    EXPECT_EQ(commands.beam->x, -6.0);
    EXPECT_EQ(commands.beam->y, 0.5);
    EXPECT_EQ(commands.beam->angle_deg, -90.0);
    EXPECT_EQ(commands.say, std::vector<std::string>{"a;b\""});
    EXPECT_TRUE(commands.pass);
    EXPECT_TRUE(commands.syn);
}

TEST(CommandsDecode, LaterFramesAddAndOverwrite) {
    Commands commands;
    decode("(he1 1)(he2 2)(say one)", commands);
    decode("(he1 3)(say two)", commands);
    EXPECT_EQ(rate(commands, JointId::HeadYaw), 3.0);
    EXPECT_EQ(rate(commands, JointId::HeadPitch), 2.0);
    EXPECT_EQ(commands.say, (std::vector<std::string>{"one", "two"}));
}

TEST(CommandsDecode, UnknownAndDamagedAreCountedAndTheRestStands) {
    Commands commands;
    EXPECT_EQ(decode("(proxy dash 50 0 0)(he1 nan)(he2)(lae1 x)(lae2 inf)(lae3 (1))(beam 1 2)"
                     "(beam 1 2 nan)(scene)(init (unum x))(init (teamname))(say)(say (a))atom()"
                     "(rae1 0.5)(syn)",
                     commands),
              15);
    Commands expected;
    expected.joint_rates[nao::index(JointId::RShoulderPitch)] = 0.5;
    EXPECT_EQ(commands.joint_rates, expected.joint_rates);
    EXPECT_FALSE(commands.beam);
    EXPECT_FALSE(commands.scene);
    EXPECT_FALSE(commands.init);
    EXPECT_TRUE(commands.say.empty());
    EXPECT_TRUE(commands.syn);
}

TEST(CommandsDecode, SurplusArgumentsAreIgnored) {
    Commands commands;
    EXPECT_EQ(decode("(say two words)(he1 1 2)", commands), 0);
    EXPECT_EQ(commands.say, std::vector<std::string>{"two"});
    EXPECT_EQ(rate(commands, JointId::HeadYaw), 1.0);
}

TEST(CommandsDecode, WholeExpressionsBeforeAnUnbalancedOneCount) {
    Commands commands;
    EXPECT_EQ(decode("(he1 1)(he2 2", commands), 1);
    EXPECT_EQ(rate(commands, JointId::HeadYaw), 1.0);
    EXPECT_FALSE(rate(commands, JointId::HeadPitch));
}

TEST(CommandsEncode, OrderAndForm) {
    Commands commands;
    commands.joint_rates[nao::index(JointId::LAnkleRoll)] = -0.5;
    commands.joint_rates[nao::index(JointId::HeadYaw)] = 1e-7;
    commands.scene = SceneCommand{"rsg/agent/nao/nao.rsg", {}};
    commands.init = InitCommand{0, "Reds"};
    commands.beam = BeamCommand{-14.0, 0.0, 0.0};
    commands.say = {"hello"};
    commands.syn = commands.pass = true;
    std::string out;
    encode(commands, out);
    EXPECT_EQ(out,
              "(he1 0.00000)(lle6 -0.50000)(scene rsg/agent/nao/nao.rsg)"
              "(init (unum 0)(teamname Reds))(beam -14 0 0)(say hello)(pass)(syn)");
}

RC_GTEST_PROP(Commands, RoundTrip, ()) {
    Commands sent;
    for (auto& joint : sent.joint_rates) joint = *maybe(centi());
    if (*rc::gen::arbitrary<bool>()) {
        sent.scene = SceneCommand{*word(), *rc::gen::container<std::vector<std::string>>(word())};
    }
    if (*rc::gen::arbitrary<bool>()) sent.init = InitCommand{*rc::gen::arbitrary<int>(), *word()};
    if (*rc::gen::arbitrary<bool>()) {
        sent.beam = BeamCommand{*rc::gen::arbitrary<double>(), *centi(), *centi()};
    }
    sent.say = *rc::gen::container<std::vector<std::string>>(word());
    sent.syn = *rc::gen::arbitrary<bool>();
    sent.pass = *rc::gen::arbitrary<bool>();

    std::string text;
    encode(sent, text);
    Commands read;
    RC_ASSERT(decode(text, read) == 0);
    RC_ASSERT(read.joint_rates == sent.joint_rates);
    RC_ASSERT(read.scene.has_value() == sent.scene.has_value());
    if (sent.scene) {
        RC_ASSERT(read.scene->file == sent.scene->file);
        RC_ASSERT(read.scene->arguments == sent.scene->arguments);
    }
    RC_ASSERT(read.init.has_value() == sent.init.has_value());
    if (sent.init) {
        RC_ASSERT(read.init->unum == sent.init->unum);
        RC_ASSERT(read.init->team == sent.init->team);
    }
    RC_ASSERT(read.beam.has_value() == sent.beam.has_value());
    if (sent.beam) {
        RC_ASSERT(read.beam->x == sent.beam->x);
        RC_ASSERT(read.beam->y == sent.beam->y);
        RC_ASSERT(read.beam->angle_deg == sent.beam->angle_deg);
    }
    RC_ASSERT(read.say == sent.say);
    RC_ASSERT(read.syn == sent.syn);
    RC_ASSERT(read.pass == sent.pass);
}

}  // namespace
}  // namespace k3d::wire
