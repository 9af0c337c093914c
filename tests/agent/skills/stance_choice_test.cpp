// SPDX-License-Identifier: BSD-3-Clause
// Tests of the choice among kicks: by the time their stances take, and not changed for a trifle.
#include "agent/skills/stance_choice.h"

#include <gtest/gtest.h>

namespace k3d::agent::skills {
namespace {

const SkillConfig kConfig;
const Vec2 kBall(0.0, 0.0);
const Vec2 kTarget(5.0, 0.0);

/// Straight ahead, and a quarter turn to the left and to the right; the latter not beyond 6 m.
KickGeometry three_ways() {
    return {3,
            [](int strike, double distance) { return strike == 0 || distance < 6.0; },
            [](int strike, const Vec2& ball, double yaw) {
                const double aim = strike == 0 ? 0.0 : strike == 1 ? kPi / 2.0 : -kPi / 2.0;
                const double heading = wrap_angle(yaw - aim);
                return Pose2{ball - direction(heading) * 0.2, heading};
            },
            [](const motion::Kick&) { return true; },
            [](double wanted) { return wanted; }};
}

/// A robot at the ball that looks this way.
Pose2 behind(double yaw) { return {kBall - direction(yaw) * 0.2, yaw}; }

int chosen(const Pose2& self, int kept, const Vec2& target = kTarget) {
    return soonest_stance(self, kBall, target, kept, three_ways(), kConfig).strike;
}

TEST(StanceChoice, TakesTheKickForWhichItNeedNotWalkRound) {
    EXPECT_EQ(chosen(behind(0.0), -1), 0);
    EXPECT_EQ(chosen(behind(-kPi / 2.0), -1), 1);
    EXPECT_EQ(chosen(behind(kPi / 2.0), -1), 2);
    const Stance there =
        soonest_stance(behind(-kPi / 2.0), kBall, kTarget, -1, three_ways(), kConfig);
    EXPECT_EQ(there.time, 0.0);
    EXPECT_NEAR(there.pose.yaw, -kPi / 2.0, 1e-12);
}

TEST(StanceChoice, WhoNeverAsksForMoreTakesTheKicksForThat) {
    KickGeometry kick = three_ways();
    kick.possible = [](const motion::Kick& wish) { return wish.distance < 6.0; };
    const KickGeometry capped = no_farther(kick, 5.5);
    EXPECT_FALSE(kick.suits(1, 8.0));
    EXPECT_TRUE(capped.suits(1, 8.0));
    EXPECT_FALSE(kick.possible({{}, 0.0, 8.0}));
    EXPECT_TRUE(capped.possible({{}, 0.0, 8.0}));
    EXPECT_EQ(capped.reach(8.0), 5.5);
    EXPECT_EQ(capped.reach(4.0), 4.0);
}

TEST(StanceChoice, LeavesOutWhatDoesNotSuitTheDistance) {
    EXPECT_EQ(chosen(behind(kPi / 2.0), 2, {8.0, 0.0}), 0);
}

TEST(StanceChoice, KeepsToAKickWhileAnotherIsLittleSooner) {
    const double middle = kPi / 4.0;  // as far from one stance as from the other
    for (const double off : {-0.05, 0.0, 0.05}) {
        EXPECT_EQ(chosen(behind(middle + off), 0), 0);
        EXPECT_EQ(chosen(behind(middle + off), 2), 2);
    }
    EXPECT_EQ(chosen(behind(middle + 0.6), 0), 2);
    EXPECT_EQ(chosen(behind(middle - 0.6), 2), 0);
}

TEST(StanceChoice, TheFirstIsPreferredWhenTimesAreEqual) {
    EXPECT_EQ(chosen({{-3.0, -3.0}, kPi / 4.0}, -1), 0);
}

TEST(TimeToStand, GrowsWithTheWayTheTurnAndTheBallInBetween) {
    const Pose2 stance = behind(0.0);
    EXPECT_EQ(time_to_stand(stance, stance, kBall, kConfig), 0.0);
    const auto time = [&](const Pose2& self) { return time_to_stand(self, stance, kBall, kConfig); };
    EXPECT_LT(time({{-0.4, 0.0}, 0.0}), time({{-0.8, 0.0}, 0.0}));
    EXPECT_LT(time({{-0.4, 0.0}, 0.0}), time({{-0.4, 0.0}, 2.0}));
    EXPECT_LT(time({{-0.6, 0.0}, 0.0}), time({{0.2, 0.0}, 0.0})) << "the ball lies in the way";
    // Round the ball a robot goes sideways, much slower than forward.
    EXPECT_GT(time({{0.2, 0.0}, kPi}), 3.0);
}

}  // namespace
}  // namespace k3d::agent::skills
