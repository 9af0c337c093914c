// SPDX-License-Identifier: BSD-3-Clause
// Tests of steering: bearings, slowing down, stopping, obstacles; and a walk played through.
#include "agent/skills/go_to.h"

#include <gtest/gtest.h>

namespace k3d::agent::skills {
namespace {

const SkillConfig kConfig;

/// Where a perfect walk ends after `seconds`, and how near it came to `watch`.
struct Ride {
    Pose2 end;
    double nearest;
};
Ride ride(Pose2 self, const Pose2& goal, std::vector<Obstacle> obstacles, double seconds,
          Vec2 watch = {100.0, 100.0}) {
    GoTo go_to;
    double nearest = 1e9;
    for (int i = 0; i < static_cast<int>(seconds / 0.02); ++i) {
        const motion::BodyRequest r = go_to.step(self, goal, obstacles, kConfig);
        if (const auto* w = std::get_if<motion::Walk>(&r))
            self = self.then({Vec2(w->forward, w->left) * 0.02, w->turn * 0.02});
        nearest = std::min(nearest, (self.position - watch).norm());
    }
    return {self, nearest};
}

TEST(WalkTo, AheadBesideBehind) {
    const motion::Walk ahead = walk_to({}, {{3.0, 0.0}, 0.0}, {}, kConfig);
    EXPECT_DOUBLE_EQ(ahead.forward, kConfig.forward_speed);
    EXPECT_DOUBLE_EQ(ahead.turn, 0.0);
    const motion::Walk left = walk_to({}, {{0.0, 3.0}, 0.0}, {}, kConfig);
    EXPECT_NEAR(left.forward, 0.0, 1e-9);
    EXPECT_DOUBLE_EQ(left.turn, kConfig.brisk_turn_rate);
    const motion::Walk behind = walk_to({}, {{-3.0, -0.1}, 0.0}, {}, kConfig);
    EXPECT_NEAR(behind.forward, 0.0, 1e-9);
    EXPECT_DOUBLE_EQ(behind.turn, -kConfig.brisk_turn_rate);
}

TEST(WalkTo, BriskOnlyWhileThePlaceIsFar) {
    const double far = 1.2 * kConfig.brisk_distance;
    const motion::Walk beyond = walk_to({}, {{0.0, far}, kPi / 2.0}, {}, kConfig);
    EXPECT_TRUE(beyond.brisk);
    EXPECT_DOUBLE_EQ(beyond.turn, kConfig.brisk_turn_rate);
    const double near = 0.9 * kConfig.brisk_distance;
    const motion::Walk within = walk_to({}, {{0.0, near}, kPi / 2.0}, {}, kConfig);
    EXPECT_FALSE(within.brisk);
    EXPECT_DOUBLE_EQ(within.turn, kConfig.turn_rate);
    EXPECT_FALSE(walk_onto({}, {0.0, far}, {}, kConfig).brisk);
}

TEST(WalkTo, TurnedAsTakesTheLeastTime) {
    // Half a metre back with the same heading: two turns would take longer than walking backwards.
    const motion::Walk back = walk_to({}, {{-0.6, 0.0}, 0.0}, {}, kConfig);
    EXPECT_LT(back.forward, -0.3);
    EXPECT_NEAR(back.turn, 0.0, 1e-9);
    // The same place, to be looked back from: the turn is due anyway.
    const motion::Walk about = walk_to({}, {{-0.6, 0.0}, 3.0}, {}, kConfig);
    EXPECT_NEAR(about.forward, 0.0, 1e-9);
    EXPECT_DOUBLE_EQ(std::abs(about.turn), kConfig.turn_rate);
}

TEST(WalkTo, NearTheGoalInAnyDirectionWithTheFinalHeading) {
    const motion::Walk side = walk_to({}, {{0.0, 0.05}, 0.3}, {}, kConfig);
    EXPECT_NEAR(side.forward, 0.0, 1e-12);
    EXPECT_NEAR(side.left, 0.05 * kConfig.gain, 1e-12);
    EXPECT_NEAR(side.turn, 0.3 * kConfig.turn_gain, 1e-12);
    const motion::Walk back = walk_to({}, {{-0.3, 0.0}, 0.0}, {}, kConfig);
    EXPECT_NEAR(back.forward, -kConfig.backward_speed, 1e-9);
}

TEST(WalkTo, DiagonalKeepsItsDirectionWithinTheLimits) {
    const motion::Walk w = walk_to({}, {{0.2, 0.2}, 0.0}, {}, kConfig);
    EXPECT_NEAR(w.forward, w.left, 1e-12);
    EXPECT_LE(w.left, kConfig.side_speed + 1e-12);
}

TEST(GoTo, ArrivesFromEverywhereAndStands) {
    for (const Vec2& start : {Vec2(-3.0, 0.0), Vec2(2.0, 2.0), Vec2(0.3, -0.2), Vec2(0.0, 4.0)})
        for (const double yaw : {0.0, 2.0, -3.0}) {
            const Ride r = ride({start, yaw}, {{0.0, 0.0}, 1.0}, {}, 20.0);
            EXPECT_LT(r.end.position.norm(), kConfig.arrive_distance);
            EXPECT_LT(std::abs(wrap_angle(r.end.yaw - 1.0)), kConfig.arrive_angle);
        }
}

TEST(GoTo, StartsAgainOnlyWhenClearlyOff) {
    GoTo go_to;
    const Pose2 goal{};
    EXPECT_TRUE(std::holds_alternative<motion::Stand>(go_to.step({}, goal, {}, kConfig)));
    EXPECT_TRUE(std::holds_alternative<motion::Stand>(go_to.step({{0.2, 0.0}, 0.0}, goal, {}, kConfig)));
    EXPECT_TRUE(std::holds_alternative<motion::Walk>(go_to.step({{0.4, 0.0}, 0.0}, goal, {}, kConfig)));
    EXPECT_TRUE(std::holds_alternative<motion::Walk>(go_to.step({{0.2, 0.0}, 0.0}, goal, {}, kConfig)));
}

TEST(Waypoint, FreeWayAndObstacleOnTheGoalChangeNothing) {
    const std::vector<Obstacle> beside{{{1.0, 2.0}, 0.5}, {{-1.0, 0.0}, 0.5}, {{4.0, 0.0}, 0.5}};
    EXPECT_EQ(waypoint({0.0, 0.0}, {3.0, 0.0}, beside), Vec2(3.0, 0.0));
    const std::vector<Obstacle> on_goal{{{3.0, 0.1}, 0.5}};
    EXPECT_EQ(waypoint({0.0, 0.0}, {3.0, 0.0}, on_goal), Vec2(3.0, 0.0));
}

TEST(Waypoint, PassesOnTheFreeSide) {
    const std::vector<Obstacle> left{{{1.0, 0.2}, 0.5}};
    EXPECT_LT(waypoint({0.0, 0.0}, {3.0, 0.0}, left).y(), -0.2);
    const std::vector<Obstacle> right{{{1.0, -0.2}, 0.5}};
    EXPECT_GT(waypoint({0.0, 0.0}, {3.0, 0.0}, right).y(), 0.2);
}

TEST(GoTo, WalksAroundARobotAndArrives) {
    const Vec2 robot(1.5, 0.05);
    const Ride r = ride({{-0.5, 0.0}, 0.0}, {{3.5, 0.0}, 0.0}, {{robot, 0.5}}, 20.0, robot);
    EXPECT_LT((r.end.position - Vec2(3.5, 0.0)).norm(), kConfig.arrive_distance);
    EXPECT_GT(r.nearest, 0.4);
}

}  // namespace
}  // namespace k3d::agent::skills
