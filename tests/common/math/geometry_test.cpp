// SPDX-License-Identifier: BSD-3-Clause
// Angles and planar poses.
#include "common/math/geometry.h"

#include <gtest/gtest.h>

namespace k3d {
namespace {

TEST(Geometry, WrapKeepsTheAngleInItsHalfOpenRange) {
    EXPECT_DOUBLE_EQ(wrap_angle(kPi), kPi);
    EXPECT_DOUBLE_EQ(wrap_angle(-kPi), kPi);
    EXPECT_NEAR(wrap_angle(7.0 * kPi + 0.1), -kPi + 0.1, 1e-12);
    EXPECT_EQ(wrap_degrees(180.0), 180.0);
    EXPECT_EQ(wrap_degrees(-180.0), 180.0);
    EXPECT_EQ(wrap_degrees(-190.0), 170.0);
    EXPECT_EQ(wrap_degrees(725.0), 5.0);
}

TEST(Geometry, AngleAtTheMiddlePoint) {
    EXPECT_NEAR(angle_at({1, 0}, {0, 0}, {0, 3}), kPi / 2.0, 1e-12);
    EXPECT_NEAR(angle_at({0, 3}, {0, 0}, {1, 0}), kPi / 2.0, 1e-12);
    EXPECT_NEAR(angle_at({2, 1}, {1, 1}, {-4, 1}), kPi, 1e-12);
    EXPECT_EQ(angle_at({1, 1}, {1, 1}, {5, 5}), 0.0);
}

TEST(Geometry, AQuarterTurnAboutEachAxisTakesTheNextToTheOneBehind) {
    EXPECT_TRUE((about_x(kPi / 2.0) * Vec3::UnitY()).isApprox(Vec3::UnitZ(), 1e-12));
    EXPECT_TRUE((about_y(kPi / 2.0) * Vec3::UnitZ()).isApprox(Vec3::UnitX(), 1e-12));
    EXPECT_TRUE((about_z(kPi / 2.0) * Vec3::UnitX()).isApprox(Vec3::UnitY(), 1e-12));
}

TEST(Geometry, PointsOutsideASquareAreMovedToItsEdge) {
    EXPECT_EQ(within_square({1.0, -2.0}, 3.0), Vec2(1.0, -2.0));
    EXPECT_EQ(within_square({4.0, -2.0}, 3.0), Vec2(3.0, -2.0));
    EXPECT_EQ(within_square({-4.0, 9.0}, 3.0), Vec2(-3.0, 3.0));
}

TEST(Geometry, PosesTurnLocalIntoGlobalAndBack) {
    const Pose2 pose{{2.0, -1.0}, radians(90.0)};
    EXPECT_TRUE(pose.to_global({1.0, 0.0}).isApprox(Vec2(2.0, 0.0), 1e-12));
    EXPECT_TRUE(pose.to_global({0.0, 1.0}).isApprox(Vec2(1.0, -1.0), 1e-12));
    const Vec2 point(-3.0, 7.0);
    EXPECT_TRUE(pose.to_local(pose.to_global(point)).isApprox(point, 1e-12));
    const Pose2 after = pose.then({{1.0, 0.0}, radians(100.0)});
    EXPECT_TRUE(after.position.isApprox(Vec2(2.0, 0.0), 1e-12));
    EXPECT_NEAR(degrees(after.yaw), -170.0, 1e-9);
}

}  // namespace
}  // namespace k3d
