// SPDX-License-Identifier: BSD-3-Clause
// Tests of the team message: round trip within the grid, legal bytes, damage found, turns.
#include "agent/talk/message.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "agent/talk/slots.h"

namespace k3d::agent::talk {
namespace {

constexpr double kGrid = 0.1;  // m: what a position may be off, on each axis, is half of it
constexpr double kStepV = 25.5 / 126.0;  // m/s

double milli(int low, int high) { return *rc::gen::inRange(low, high + 1) / 1000.0; }
Vec2 any_point() { return {milli(-16000, 16000), milli(-11000, 11000)}; }

Message any_message() {
    Message m;
    m.unum = *rc::gen::inRange(1, 12);
    m.position = any_point();
    m.fallen = *rc::gen::arbitrary<bool>();
    if (*rc::gen::arbitrary<bool>()) {
        m.ball = any_point();
        m.ball_velocity = {milli(-12750, 12750), milli(-12750, 12750)};
    }
    m.claims_k1 = *rc::gen::arbitrary<bool>();
    if (*rc::gen::arbitrary<bool>()) m.target = any_point();
    m.k2 = *rc::gen::inRange(0, 12);
    if (*rc::gen::arbitrary<bool>()) {
        const Vec2 from_speaker(milli(-6290, 6290), milli(-6290, 6290));
        m.opponent = {*rc::gen::inRange(1, 12), m.position + from_speaker};
    }
    return m;
}

void expect_near(const Vec2& a, const Vec2& b) {
    RC_ASSERT((a - b).cwiseAbs().maxCoeff() <= kGrid / 2 + 1e-9);
}

RC_GTEST_PROP(Message, RoundTripWithinTheGrid, ()) {
    const Message m = any_message();
    const auto back = decode(encode(m));
    RC_ASSERT(back.has_value());
    RC_ASSERT(back->unum == m.unum);
    expect_near(back->position, m.position);
    RC_ASSERT(back->fallen == m.fallen);
    RC_ASSERT(back->ball.has_value() == m.ball.has_value());
    if (m.ball) {
        expect_near(*back->ball, *m.ball);
        RC_ASSERT((back->ball_velocity - m.ball_velocity).cwiseAbs().maxCoeff() <= kStepV / 2 + 1e-9);
    }
    RC_ASSERT(back->claims_k1 == m.claims_k1);
    RC_ASSERT(back->target.has_value() == m.target.has_value());
    if (m.target) expect_near(*back->target, *m.target);
    RC_ASSERT(back->k2 == m.k2);
    RC_ASSERT(back->opponent.has_value() == m.opponent.has_value());
    if (m.opponent) {
        RC_ASSERT(back->opponent->unum == m.opponent->unum);
        expect_near(back->opponent->position - back->position, m.opponent->position - m.position);
    }
}

RC_GTEST_PROP(Message, TwentyLegalBytes, ()) {
    const std::string text = encode(any_message());
    RC_ASSERT(text.size() == kMessageBytes);
    for (const char c : text) {
        RC_ASSERT(c >= 0x21 && c <= 0x7E);
        RC_ASSERT(std::string_view("()\"'\\;").find(c) == std::string_view::npos);
    }
}

RC_GTEST_PROP(Message, OneChangedByteIsFound, ()) {
    std::string text = encode(any_message());
    const auto at = static_cast<std::size_t>(*rc::gen::inRange(0, 20));
    const char other = *rc::gen::inRange<char>(0x21, 0x7F);
    RC_PRE(other != text[at]);
    text[at] = other;
    RC_ASSERT(!decode(text));
}

RC_GTEST_PROP(Message, AnyTextIsHarmless, (const std::string& text)) {
    RC_ASSERT(!decode(text) || text.size() == kMessageBytes);
}

TEST(Message, ZeroIsExact) {
    Message m;
    m.unum = 3;
    m.target = Vec2(0.0, 0.0);
    const auto back = decode(encode(m));
    ASSERT_TRUE(back);
    EXPECT_EQ(*back->target, Vec2(0.0, 0.0));
}

TEST(Message, FarOffIsClampedToTheField) {
    Message m;
    m.unum = 1;
    m.position = {100.0, -100.0};
    EXPECT_NEAR((decode(encode(m))->position - Vec2(16.0, -11.0)).norm(), 0.0, 1e-9);
}

TEST(Message, AnOpponentTooFarFromTheSpeakerIsNotTold) {
    Message m;
    m.unum = 1;
    m.position = {-4.0, 0.0};
    m.opponent = {2, {2.0, 1.0}};
    EXPECT_TRUE(decode(encode(m))->opponent);
    m.opponent = {2, {2.5, 1.0}};
    EXPECT_FALSE(decode(encode(m))->opponent);
    m.opponent = {0, {-4.0, 1.0}};
    EXPECT_FALSE(decode(encode(m))->opponent) << "nobody has this number";
}

TEST(Message, ForeignTextIsNone) {
    EXPECT_FALSE(decode(""));
    EXPECT_FALSE(decode("hello"));
    EXPECT_FALSE(decode("00000000000000000000"));
    EXPECT_FALSE(decode("k0000000000000000000"));
}

TEST(Slots, EachKeeperSpeaksOnceATurnAndNeverInNeighbouringCycles) {
    for (const int keepers : {1, 3, 5}) {
        int last = -2;
        std::multiset<int> spoke;
        for (int cycle = 0; cycle < 2 * keepers * 10; ++cycle)
            for (int unum = 1; unum <= keepers; ++unum)
                if (may_speak(cycle * kCycleSeconds, unum, keepers)) {
                    EXPECT_GE(cycle - last, 2);
                    last = cycle;
                    spoke.insert(unum);
                }
        for (int unum = 1; unum <= keepers; ++unum) EXPECT_EQ(spoke.count(unum), 10u);
    }
}

}  // namespace
}  // namespace k3d::agent::talk
