// SPDX-License-Identifier: BSD-3-Clause
// Tests of the features f1..f8: values computed by hand.
#include "agent/decision/keepaway/features.h"

#include <gtest/gtest.h>

#include <cmath>

namespace k3d::agent::decision {
namespace {

constexpr double kIdeal = 6.0;

/// Point at the origin; ball 6 m behind it, takers at (3, 4) and (0, 2).
PassSituation two_takers() {
    PassSituation s;
    s.ball = {-6.0, 0.0};
    s.takers = {{{3.0, 4.0}, {3.0, 6.0}}, {{0.0, 2.0}, {0.0, 1.0}}};
    s.receivers = {{1.0, 2.0}, {-1.0, 0.0}};
    return s;
}

TEST(Features, F1IsTheSmallestAngleAtThePoint) {
    // Taker (0, 2): 90 degrees from the ball's direction (-1, 0); taker (3, 4): 126.87.
    EXPECT_NEAR(features_at({0.0, 0.0}, two_takers(), kIdeal)[0], 90.0, 1e-9);
    PassSituation s = two_takers();
    s.takers[1].position = {3.0, -0.001};
    EXPECT_NEAR(features_at({0.0, 0.0}, s, kIdeal)[0], 126.8699, 1e-3);
    s.takers[1].position = {-3.0, 0.0};  // in the line of the pass
    EXPECT_NEAR(features_at({0.0, 0.0}, s, kIdeal)[0], 0.0, 1e-9);
}

TEST(Features, F2SumsInverseDistancesOfAllTakers) {
    PassSituation s = two_takers();
    EXPECT_NEAR(features_at({0.0, 0.0}, s, kIdeal)[1], 1.0 / 5.0 + 1.0 / 2.0, 1e-12);
    s.takers.push_back({{4.0, 0.0}, {4.0, 0.0}});
    EXPECT_NEAR(features_at({0.0, 0.0}, s, kIdeal)[1], 0.2 + 0.5 + 0.25, 1e-12);
    EXPECT_TRUE(std::isfinite(features_at({4.0, 0.0}, s, kIdeal)[1]));
}

TEST(Features, F3LikesTheIdealPass) {
    EXPECT_NEAR(features_at({0.0, 0.0}, two_takers(), 6.0)[2], 1.0, 1e-12);
    EXPECT_NEAR(features_at({-4.0, 0.0}, two_takers(), 6.0)[2], 17.0, 1e-12);
    EXPECT_NEAR(features_at({-4.0, 0.0}, two_takers(), 4.0)[2], 5.0, 1e-12);
}

TEST(Features, F4IsTheSquaredDistanceToTheClosestReceiver) {
    EXPECT_NEAR(features_at({0.0, 0.0}, two_takers(), kIdeal)[3], 1.0, 1e-12);
    EXPECT_NEAR(features_at({1.0, 4.0}, two_takers(), kIdeal)[3], 4.0, 1e-12);
}

TEST(Features, F5ToF8AreOfTheTwoNearestTakersNearestFirst) {
    // (0, 2) is nearest: its mean (0, 1) lies between it and the point, so it goes away.
    // (3, 4): from its mean (3, 6) to it (0, -2), to the point (-3, -6): acos(12 / (2 * 6.7082)).
    const Features f = features_at({0.0, 0.0}, two_takers(), kIdeal);
    EXPECT_NEAR(f[4], 180.0, 1e-9);
    EXPECT_NEAR(f[5], degrees(std::acos(12.0 / (2.0 * std::sqrt(45.0)))), 1e-9);
    EXPECT_NEAR(f[6], 1.0, 1e-12);
    EXPECT_NEAR(f[7], 2.0, 1e-12);

    PassSituation third = two_takers();
    third.takers.insert(third.takers.begin(), {{9.0, 9.0}, {0.0, 9.0}});
    const Features same = features_at({0.0, 0.0}, third, kIdeal);
    for (std::size_t i = 4; i < 8; ++i) EXPECT_EQ(same[i], f[i]);
}

TEST(Features, FewerTakersGiveNeutralValues) {
    PassSituation s = two_takers();
    s.takers.pop_back();
    const Features one = features_at({0.0, 0.0}, s, kIdeal);
    EXPECT_NEAR(one[6], 2.0, 1e-12);
    EXPECT_EQ(one[5], 90.0);
    EXPECT_EQ(one[7], 0.0);
    s.takers.clear();
    s.receivers.clear();
    const Features none = features_at({0.0, 0.0}, s, kIdeal);
    EXPECT_EQ(none, (Features{180.0, 0.0, 1.0, 0.0, 90.0, 90.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace k3d::agent::decision
