// SPDX-License-Identifier: BSD-3-Clause
// Tests of meeting a rolling ball.
#include "agent/skills/intercept.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/field/field.h"

namespace k3d::agent::skills {
namespace {

world::Ball rolling(Vec2 from, Vec2 to) {
    world::Ball b;
    b.known = b.moving = true;
    b.position = from;
    b.finish = to;
    b.velocity = field::kRollDecay * (to - from);
    return b;
}

TEST(Intercept, PerpendicularFootStaysOnThePath) {
    const world::Ball ball = rolling({0.0, 0.0}, {4.0, 0.0});
    EXPECT_EQ(perpendicular_foot({1.0, 3.0}, ball), Vec2(1.0, 0.0));
    EXPECT_EQ(perpendicular_foot({-1.0, 3.0}, ball), Vec2(0.0, 0.0));
    EXPECT_EQ(perpendicular_foot({9.0, 3.0}, ball), Vec2(4.0, 0.0));
    EXPECT_EQ(perpendicular_foot({9.0, 3.0}, rolling({1.0, 1.0}, {1.0, 1.0})), Vec2(1.0, 1.0));
}

TEST(Intercept, RollTimeIsThatOfExponentialDecay) {
    EXPECT_DOUBLE_EQ(roll_time(0.0, 4.0), 0.0);
    EXPECT_NEAR(roll_time(2.0, 4.0), std::log(2.0) / field::kRollDecay, 1e-12);
    EXPECT_TRUE(std::isinf(roll_time(4.0, 4.0)));
}

TEST(Intercept, EarliestMeetingIsReachedInTimeAndEarlierIsNot) {
    const world::Ball ball = rolling({0.0, 0.0}, {6.0, 0.0});
    const Vec2 self(3.0, 0.6);
    const Vec2 meet = earliest_meeting(self, ball, 0.7);
    EXPECT_LE((meet - self).norm() / 0.7, roll_time(meet.norm(), 6.0));
    EXPECT_LT(meet.x(), 6.0);
    const Vec2 sooner = meet - Vec2(0.1, 0.0);
    EXPECT_GT((sooner - self).norm() / 0.7 + 0.4, roll_time(sooner.norm(), 6.0));
}

TEST(Intercept, TooFarAwayMeansTheFinish) {
    EXPECT_EQ(earliest_meeting({50.0, 0.0}, rolling({0.0, 0.0}, {6.0, 0.0}), 0.7), Vec2(6.0, 0.0));
}

}  // namespace
}  // namespace k3d::agent::skills
