// SPDX-License-Identifier: BSD-3-Clause
// Say and hear: capacity, length, alphabet, direction.
#include "server/effectors/hearing.h"

#include <gtest/gtest.h>

namespace k3d::server::effectors {
namespace {

body::Player& player(body::Scene& scene, wire::Side team, int unum, const Vec3& at) {
    body::Player& p = scene.add_player(0, at);
    p.team = team;
    p.unum = unum;
    p.team_name = team == wire::Side::Left ? "Reds" : "Blues";
    return p;
}

TEST(Sayable, TakesTwentyPrintableBytes) {
    EXPECT_TRUE(sayable("abcdefghijklmnopqrst"));
    EXPECT_FALSE(sayable("abcdefghijklmnopqrstu"));
    EXPECT_FALSE(sayable(""));
    EXPECT_FALSE(sayable("a b"));
    EXPECT_FALSE(sayable("a(b"));
    EXPECT_FALSE(sayable("a\x7f"));
    EXPECT_FALSE(sayable("a\xc3\xa4"));
    EXPECT_TRUE(sayable("!\"#$%&'*+,-./;~"));
}

TEST(Ear, HearsOneMateEverySecondCycleAndTheFirstSpeakerWins) {
    body::Scene scene;
    const body::Player& listener = player(scene, wire::Side::Left, 1, {0, 0, 1});
    const body::Player& two = player(scene, wire::Side::Left, 2, {3, 0, 1});
    const body::Player& three = player(scene, wire::Side::Left, 3, {0, 3, 1});
    const body::Player& opponent = player(scene, wire::Side::Right, 1, {-3, 0, 1});
    Ear ear;
    int mates = 0;
    int opponents = 0;
    for (int cycle = 0; cycle < 100; ++cycle) {
        ear.hear_self("mine", 1.0, "Reds");
        ear.hear_other(listener, two, "two", 1.0);
        ear.hear_other(listener, three, "three", 1.0);
        ear.hear_other(listener, opponent, "theirs", 1.0);
        std::vector<wire::Heard> heard;
        ear.collect(heard);
        ASSERT_FALSE(heard.empty());
        EXPECT_FALSE(heard[0].direction_deg) << "own message first";
        for (const wire::Heard& h : heard) {
            EXPECT_NE(h.text, "three") << "the first speaker wins";
            mates += h.text == "two";
            opponents += h.text == "theirs";
        }
        EXPECT_EQ(heard.size(), cycle % 2 == 0 ? 3U : 1U);
    }
    EXPECT_EQ(mates, 50);
    EXPECT_EQ(opponents, 50);
}

TEST(Ear, DirectionIsInTheListenersTeamFrame) {
    body::Scene scene;
    const body::Player& left = player(scene, wire::Side::Left, 1, {0, 0, 1});
    const body::Player& right = player(scene, wire::Side::Right, 1, {2, 2, 1});
    Ear ear;
    std::vector<wire::Heard> heard;
    ear.hear_other(left, right, "x", 0.0);
    ear.collect(heard);
    EXPECT_NEAR(*heard.at(0).direction_deg, 45.0, 1e-9);
    Ear other;
    heard.clear();
    other.hear_other(right, left, "y", 0.0);
    other.collect(heard);
    EXPECT_NEAR(*heard.at(0).direction_deg, 45.0, 1e-9) << "turned by 180 degrees for the right";
}

TEST(Ear, HearsNothingFromBeyondFiftyMetres) {
    body::Scene scene;
    const body::Player& near = player(scene, wire::Side::Left, 1, {-24, 0, 1});
    const body::Player& far = player(scene, wire::Side::Left, 2, {27, 0, 1});
    Ear ear;
    std::vector<wire::Heard> heard;
    ear.hear_other(near, far, "x", 0.0);
    ear.collect(heard);
    EXPECT_TRUE(heard.empty());
}

}  // namespace
}  // namespace k3d::server::effectors
