// SPDX-License-Identifier: BSD-3-Clause
// Percept frames: composed frames of the reference's grammar, faults, and round trips.
#include "common/wire/percepts.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "tests/common/wire/gen.h"

namespace k3d::wire {
namespace {

using nao::JointId;

// A vision frame of a toe robot with everything in it, in the reference's order.
constexpr std::string_view kFullFrame =
    "(time (now 46.20))(GS (unum 3) (team right) (sl 1) (sr 0) (t 12.36) (pm PlayOn))"
    "(hear Reds 12.34 self abc)(hear Reds 12.34 -73.10 d;e\"f)(hear Blues 12.34 180.00 x)"
    "(GYR (n torso) (rt 0.13 -2.71 0.40))(ACC (n torso) (a 0.02 -0.11 9.79))"
    "(HJ (n hj1) (ax -0.00))(HJ (n hj2) (ax 40.07))"
    "(See (G2R (pol 17.61 -3.35 4.29)) (G1R (pol 17.47 3.31 4.11)) (F1R (pol 18.64 18.90 -1.57)) "
    "(B (pol 8.51 -0.22 -3.54)) "
    "(P (team Blues) (id 1) (head (pol 16.98 -0.22 0.15)) (rlowerarm (pol 16.83 -0.06 -0.81)) "
    "(lfoot (pol 17.02 0.11 -1.98))) "
    "(P (team Reds) (id 3) (llowerarm (pol 0.18 33.20 -21.33)) (rfoot (pol 0.51 -4.00 -59.10))) "
    "(mypos -3.20 0.11 0.53) (myorien -12.50) (ballpos 1.00 -0.40 0.04) "
    "(L (pol 12.11 -40.80 -2.41) (pol 12.96 -37.74 -2.38)) "
    "(L (pol 3.40 12.25 -28.69) (pol 3.17 36.82 -31.20)))"
    "(HJ (n raj1) (ax -54.30))(HJ (n raj2) (ax 0.28))(HJ (n raj3) (ax 0.00))(HJ (n raj4) (ax 0.01))"
    "(HJ (n laj1) (ax -54.29))(HJ (n laj2) (ax -0.26))(HJ (n laj3) (ax 0.02))"
    "(HJ (n laj4) (ax -0.00))"
    "(HJ (n rlj1) (ax 0.03))(HJ (n rlj2) (ax -26.84))(HJ (n rlj3) (ax -8.69))"
    "(HJ (n rlj4) (ax -2.91))(HJ (n rlj5) (ax 0.04))"
    "(FRP (n rf) (c -0.04 0.06 -0.02) (f 5.96 -1.11 -3.20))(HJ (n rlj6) (ax 0.63))"
    "(FRP (n rf1) (c -0.04 0.01 -0.01) (f 33.24 -15.52 31.30))(HJ (n rlj7) (ax 0.05))"
    "(HJ (n llj1) (ax 0.06))(HJ (n llj2) (ax 26.88))(HJ (n llj3) (ax -8.68))"
    "(HJ (n llj4) (ax -2.92))(HJ (n llj5) (ax 0.07))"
    "(FRP (n lf) (c 0.04 0.06 -0.02) (f -5.77 -1.11 -3.20))(HJ (n llj6) (ax 0.64))"
    "(FRP (n lf1) (c 0.03 0.01 -0.01) (f -33.24 15.52 31.30))(HJ (n llj7) (ax 0.08))";

std::string encoded(const Percepts& percepts, int type) {
    std::string out;
    encode(percepts, nao::model(type), out);
    return out;
}

double angle(const Percepts& percepts, JointId id) {
    return percepts.joints_deg[nao::index(id)];
}

TEST(PerceptsDecode, FullFrame) {
    Percepts p;
    ASSERT_EQ(decode(kFullFrame, p), 0);
    EXPECT_EQ(p.time, 46.2);
    EXPECT_EQ(p.game->unum, 3);
    EXPECT_EQ(p.game->team, Side::Right);
    EXPECT_EQ(p.game->score_left, 1);
    EXPECT_EQ(p.game->time, 12.36);
    EXPECT_EQ(p.game->play_mode, "PlayOn");
    ASSERT_EQ(p.heard.size(), 3U);
    EXPECT_FALSE(p.heard[0].direction_deg);
    EXPECT_EQ(p.heard[1].direction_deg, -73.1);
    EXPECT_EQ(p.heard[1].text, "d;e\"f");
    EXPECT_EQ(p.heard[2].team, "Blues");
    EXPECT_EQ(p.gyro_deg, Vec3(0.13, -2.71, 0.40));
    EXPECT_EQ(p.acceleration, Vec3(0.02, -0.11, 9.79));
    EXPECT_TRUE(p.has_joint.all());
    EXPECT_EQ(angle(p, JointId::HeadPitch), 40.07);
    EXPECT_EQ(angle(p, JointId::LToe), 0.08);
    EXPECT_EQ(p.feet[0]->force, Vec3(5.96, -1.11, -3.20));
    EXPECT_EQ(p.feet[3]->point, Vec3(0.03, 0.01, -0.01));
}

TEST(PerceptsDecode, FullFrameSee) {
    Percepts p;
    ASSERT_EQ(decode(kFullFrame, p), 0);
    const See& see = *p.see;
    EXPECT_FALSE(see.landmarks[static_cast<std::size_t>(field::Landmark::G1L)]);
    const Pol g2r = *see.landmarks[static_cast<std::size_t>(field::Landmark::G2R)];
    EXPECT_EQ(g2r.distance, 17.61);
    EXPECT_EQ(g2r.theta_deg, -3.35);
    EXPECT_EQ(g2r.phi_deg, 4.29);
    EXPECT_EQ(see.ball->distance, 8.51);
    ASSERT_EQ(see.players.size(), 2U);
    EXPECT_EQ(see.players[0].team, "Blues");
    EXPECT_EQ(see.players[0].unum, 1);
    EXPECT_EQ(see.players[0].lfoot->phi_deg, -1.98);
    EXPECT_FALSE(see.players[0].rfoot);
    ASSERT_EQ(see.lines.size(), 2U);
    EXPECT_EQ(see.lines[0].end.theta_deg, -37.74);
    EXPECT_EQ(*see.my_position, Vec3(-3.2, 0.11, 0.53));
    EXPECT_EQ(see.my_orientation_deg, -12.5);
    EXPECT_EQ(*see.ball_position, Vec3(1.0, -0.4, 0.04));
}

TEST(PerceptsEncode, WritesTheSameBytes) {
    Percepts p;
    decode(kFullFrame, p);
    EXPECT_EQ(encoded(p, 4), kFullFrame);
}

TEST(PerceptsEncode, FrameWithoutVisionAndContact) {
    Percepts p;
    p.time = 4.06;
    p.game = GameState{std::nullopt, std::nullopt, 0, 0, 0.0, "BeforeKickOff"};
    const std::string text = encoded(p, 0);
    EXPECT_EQ(text.substr(0, text.find("(HJ (n hj2)")),
              "(time (now 4.06))(GS (sl 0) (sr 0) (t 0.00) (pm BeforeKickOff))"
              "(GYR (n torso) (rt 0.00 0.00 0.00))(ACC (n torso) (a 0.00 0.00 0.00))"
              "(HJ (n hj1) (ax 0.00))");
    EXPECT_EQ(text.find("See"), std::string::npos);
    EXPECT_EQ(text.find("FRP"), std::string::npos);
    EXPECT_EQ(text.find("lj7"), std::string::npos) << "type 0 has no toes";
    Percepts read;
    EXPECT_EQ(decode(text, read), 0);
    EXPECT_EQ(read.has_joint.count(), 22U);
    EXPECT_FALSE(read.has_joint[nao::index(JointId::RToe)]);
    EXPECT_FALSE(read.see);
}

TEST(PerceptsEncode, EmptySeeKeepsItsBlank) {
    Percepts p;
    p.see.emplace();
    EXPECT_NE(encoded(p, 0).find("(See )"), std::string::npos);
    Percepts read;
    EXPECT_EQ(decode(encoded(p, 0), read), 0);
    EXPECT_TRUE(read.see);
}

TEST(PerceptsEncode, NeverWritesInfinitiesOrExponents) {
    Percepts p;
    p.gyro_deg = Vec3(std::numeric_limits<double>::infinity(), 1e9, -1e-9);
    EXPECT_NE(encoded(p, 0).find("(rt nan 1000000000.00 -0.00)"), std::string::npos);
}

TEST(PerceptsDecode, ResetsWhatThePreviousFrameLeft) {
    Percepts p;
    decode(kFullFrame, p);
    ASSERT_EQ(decode("(time (now 46.22))(HJ (n hj1) (ax 1.00))", p), 0);
    EXPECT_EQ(p.time, 46.22);
    EXPECT_FALSE(p.game);
    EXPECT_TRUE(p.heard.empty());
    EXPECT_EQ(p.gyro_deg, Vec3(0, 0, 0));
    EXPECT_EQ(p.has_joint.count(), 1U);
    EXPECT_FALSE(p.feet[0]);
    EXPECT_FALSE(p.see);
    decode(kFullFrame, p);
    ASSERT_EQ(decode("(GS (sl 0) (sr 0) (t 0.00) (pm PlayOn))(See (B (pol 1.00 2.00 3.00)))", p),
              0);
    EXPECT_FALSE(p.game->unum);
    EXPECT_FALSE(p.game->team);
    EXPECT_TRUE(p.see->players.empty());
    EXPECT_TRUE(p.see->lines.empty());
    EXPECT_FALSE(p.see->my_position);
}

TEST(PerceptsDecode, UnknownAndDamagedGroupsAreCountedAndTheRestStands) {
    for (const char* text : {"(AgentState (temp 48) (battery 75))",
                             "(time)",
                             "(time (now x))",
                             "(time (now 1 2))",
                             "(GS (ti 1))",
                             "(GS (sl 0.5))",
                             "(GS (team top))",
                             "(GS (unum 12))",
                             "(GS (pm))",
                             "(GS atom)",
                             "(hear 12.34 self abc)",
                             "(hear Reds x self abc)",
                             "(hear Reds 1 y abc)",
                             "(hear Reds 1 self (a))",
                             "(GYR (n torso) (rt 1 2))",
                             "(hear Reds 1e10 self abc)",
                             "(hear Reds 1 1e300 abc)",
                             "(time (now 1e300))",
                             "(GYR (n torso) (rt 1e300 0 0))",
                             "(See (B (pol 1e200 -30 -9)))",
                             "(HJ (n hj1) (ax -1.1e9))",
                             "(ACC (n torso) (a 1 2 nan))",
                             "(HJ (n xyz) (ax 1.00))",
                             "(HJ (n hj1))",
                             "(HJ (ax 1.00))",
                             "(HJ (n hj1) (ax 1 2))",
                             "(FRP (n rf) (c 1 2 3))",
                             "(FRP (n xx) (c 1 2 3) (f 1 2 3))",
                             "(See (X (pol 1 2 3)))",
                             "(See (B (pol 1 2)))",
                             "(See (B 1 2 3))",
                             "(See (L (pol 1 2 3)))",
                             "(See (L (pol nan nan nan) (pol 1 2 3)))",
                             "(See (L (pol 1 2 3) (pol 1 2 3) (pol 1 2 3)))",
                             "(See (P (id 1)))",
                             "(See (P (team A) (id 1) (tail (pol 1 2 3))))",
                             "(See (mypos 1 2))",
                             "atom",
                             "()",
                             "(See ",
                             "(See ))"}) {
        Percepts p;
        EXPECT_EQ(decode(std::string("(ACC (n torso) (a 1.00 2.00 3.00))") + text, p), 1) << text;
        EXPECT_EQ(p.acceleration, Vec3(1, 2, 3)) << text;
        EXPECT_TRUE(p.heard.empty()) << text;
        EXPECT_TRUE(p.has_joint.none()) << text;
        EXPECT_FALSE(p.feet[0]) << text;
        EXPECT_TRUE(!p.see || (!p.see->ball && p.see->lines.empty())) << text;
    }
}

TEST(PerceptsDecode, PlayerWithoutTeamOrNumberIsDropped) {
    Percepts p;
    EXPECT_EQ(decode("(See (P (team A) (id 0) (head (pol 1 2 3))) (P (team B) (id 2)))", p), 2);
    ASSERT_EQ(p.see->players.size(), 1U);
    EXPECT_EQ(p.see->players[0].team, "B");
}

rc::Gen<Pol> pols() {
    return rc::gen::apply(
        [](double d, double t, double f) {
            return Pol{d, t, f};
        },
        centi(), centi(), centi());
}

rc::Gen<See> sees() {
    return rc::gen::exec([] {
        See see;
        for (auto& landmark : see.landmarks) landmark = *maybe(pols());
        see.ball = *maybe(pols());
        const int players = *rc::gen::inRange(0, 6);
        for (int i = 0; i < players; ++i) {
            see.players.push_back({*word(), *rc::gen::inRange(1, 12), *maybe(pols()),
                                   *maybe(pols()), *maybe(pols()), *maybe(pols()), *maybe(pols())});
        }
        const int lines = *rc::gen::inRange(0, 4);
        for (int i = 0; i < lines; ++i) see.lines.push_back({*pols(), *pols()});
        see.my_position = *maybe(centi_vector());
        see.my_orientation_deg = *maybe(centi());
        see.ball_position = *maybe(centi_vector());
        return see;
    });
}

Percepts any_percepts(const nao::Model& model) {
    Percepts p;
    p.time = *centi();
    p.gyro_deg = *centi_vector();
    p.acceleration = *centi_vector();
    if (*rc::gen::arbitrary<bool>()) {
        p.game = GameState{*maybe(rc::gen::inRange(1, 12)),
                           *maybe(rc::gen::element(Side::Left, Side::Right, Side::None)),
                           *rc::gen::arbitrary<int>(),
                           *rc::gen::arbitrary<int>(),
                           *centi(),
                           *word()};
    }
    const int heard = *rc::gen::inRange(0, 4);
    for (int i = 0; i < heard; ++i) {
        p.heard.push_back({*word(), *centi(), *maybe(centi()), *word()});
    }
    for (const nao::JointDef& joint : model.joints) p.joints_deg[nao::index(joint.id)] = *centi();
    const std::size_t feet = model.joints.size() == nao::kJointCount ? 4 : 2;
    for (std::size_t i = 0; i < feet; ++i) {
        if (*rc::gen::arbitrary<bool>()) p.feet[i] = FootForce{*centi_vector(), *centi_vector()};
    }
    p.see = *maybe(sees());
    return p;
}

RC_GTEST_PROP(Percepts, RoundTrip, ()) {
    const int type = *rc::gen::inRange(0, nao::kTypeCount);
    const Percepts sent = any_percepts(nao::model(type));
    const std::string text = encoded(sent, type);
    Percepts read;
    decode(kFullFrame, read);  // what was there before must not matter
    RC_ASSERT(decode(text, read) == 0);
    RC_ASSERT(encoded(read, type) == text);  // two decimals hold every generated number
    RC_ASSERT(read.time == sent.time);
    RC_ASSERT(read.joints_deg == sent.joints_deg);
    RC_ASSERT(read.heard.size() == sent.heard.size());
    RC_ASSERT(read.game.has_value() == sent.game.has_value());
    RC_ASSERT(read.see.has_value() == sent.see.has_value());
    if (sent.see) RC_ASSERT(read.see->players.size() == sent.see->players.size());
}

RC_GTEST_PROP(Percepts, DecodeTakesAnyMutilation, ()) {
    std::string text(kFullFrame);
    const int cuts = *rc::gen::inRange(1, 5);
    for (int i = 0; i < cuts; ++i) {
        const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
        text.replace(at, *rc::gen::inRange<std::size_t>(0, 10),
                     *rc::gen::container<std::string>(rc::gen::elementOf(std::string("() -.9nP"))));
    }
    Percepts read;
    const int faults = decode(text, read);
    RC_ASSERT(faults >= 0);
    for (const double a : read.joints_deg) RC_ASSERT(std::isfinite(a));
    Percepts again;
    RC_ASSERT(decode(encoded(read, 4), again) ==
              (read.game && read.game->play_mode.empty() ? 1 : 0));
}

}  // namespace
}  // namespace k3d::wire
