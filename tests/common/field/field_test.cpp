// SPDX-License-Identifier: BSD-3-Clause
// The field's tables against the figures of the reference, written out here a second time.
#include "common/field/field.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace k3d::field {
namespace {

TEST(Field, StraightLinesInDefinitionOrder) {
    constexpr std::array<std::array<double, 4>, 11> expected{{
        {0, -10, 0, 10},
        {15, -10, 15, 10},
        {-15, -10, -15, 10},
        {15, 10, -15, 10},
        {15, -10, -15, -10},
        {13.2, 3, 13.2, -3},
        {13.2, 3, 15, 3},
        {13.2, -3, 15, -3},
        {-13.2, 3, -13.2, -3},
        {-13.2, 3, -15, 3},
        {-13.2, -3, -15, -3},
    }};
    ASSERT_EQ(static_cast<std::size_t>(kStraightLineCount), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const auto& [bx, by, ex, ey] = expected[i];
        EXPECT_TRUE(lines()[i].begin.isApprox(Vec2(bx, by), 1e-12)) << i + 1;
        EXPECT_TRUE(lines()[i].end.isApprox(Vec2(ex, ey), 1e-12)) << i + 1;
    }
}

TEST(Field, CentreCircleIsAClosedDecagonOfRadiusTwo) {
    for (int k = 0; k < 10; ++k) {
        const Line& chord = lines()[static_cast<std::size_t>(11 + k)];
        EXPECT_NEAR(chord.begin.norm(), 2.0, 1e-12);
        EXPECT_NEAR(wrap_degrees(degrees(yaw_of(chord.begin)) - 36.0 * k), 0.0, 1e-9);
        const Line& next = lines()[static_cast<std::size_t>(11 + (k + 1) % 10)];
        EXPECT_LT((chord.end - next.begin).norm(), 1e-12);
    }
}

TEST(Field, LandmarksHaveTheNamesAndPlacesOfTheReference) {
    std::string names;
    for (const LandmarkDef& landmark : kLandmarks) {
        names += landmark.name;
        const bool goal = landmark.name[0] == 'G';
        EXPECT_EQ(landmark.x, landmark.name[2] == 'L' ? -15.0 : 15.0) << landmark.name;
        const double y = goal ? 1.05 : 10.0;
        EXPECT_EQ(landmark.y, landmark.name[1] == '1' ? y : -y) << landmark.name;
        EXPECT_EQ(landmark.z, goal ? 0.8 : 0.0) << landmark.name;
    }
    EXPECT_EQ(names, "G1LG2LG2RG1RF1LF2LF1RF2R");
}

TEST(Field, GoalsAreBoxesBehindTheGoalLines) {
    double nearest = 100.0;
    int panels = 0;
    for (const SolidBox& box : solids()) {
        if (!box.name.starts_with("goal")) continue;
        ++panels;
        nearest = std::min(nearest, std::abs(box.centre.x()) - box.size.x() / 2.0);
        EXPECT_EQ(box.centre.x() < 0.0, box.name.starts_with("goal-left")) << box.name;
    }
    EXPECT_EQ(panels, 8);
    EXPECT_NEAR(nearest, 15.0, 1e-12);
}

TEST(Field, WallsStandWhereTheReferenceHasThem) {
    const auto centre_of = [](std::string_view name) -> Vec3 {
        for (const SolidBox& box : solids()) {
            if (box.name == name) return box.centre;
        }
        ADD_FAILURE() << "no " << name;
        return Vec3::Zero();
    };
    EXPECT_TRUE(centre_of("wall-left").isApprox(Vec3(-24.99, 0, 0), 1e-12));
    EXPECT_TRUE(centre_of("wall-right").isApprox(Vec3(24.99, 0, 0), 1e-12));
    EXPECT_TRUE(centre_of("wall-front").isApprox(Vec3(0, -25, 0), 1e-12));
    EXPECT_TRUE(centre_of("wall-back").isApprox(Vec3(0, 25, 0), 1e-12));
}

}  // namespace
}  // namespace k3d::field
