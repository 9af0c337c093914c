// SPDX-License-Identifier: BSD-3-Clause
#include "agent/localisation/map.h"

#include <gtest/gtest.h>

namespace k3d::agent::localisation {
namespace {

perception::LineSight sight_of(const Pose2& pose, const Vec2& begin, const Vec2& end) {
    return {pose.to_local(begin), pose.to_local(end), (end - begin).norm()};
}

TEST(Map, TheRightTeamSeesTheFieldTurned) {
    const auto left = team_landmarks(wire::Side::Left);
    const auto right = team_landmarks(wire::Side::Right);
    const auto g1l = static_cast<std::size_t>(field::Landmark::G1L);
    EXPECT_EQ(left[g1l], Vec2(-15.0, 1.05));
    EXPECT_EQ(right[g1l], Vec2(15.0, -1.05));
}

TEST(Map, EveryLineIsMatchedToItselfFromAnywhere) {
    const Pose2 pose{{-4.0, 2.5}, 2.0};
    for (std::size_t k = 0; k < map_lines().size(); ++k) {
        const field::Line& line = field::lines()[k];
        const Vec2 from = line.begin + 0.1 * (line.end - line.begin);
        const Vec2 to = line.begin + 0.8 * (line.end - line.begin);
        EXPECT_EQ(match(pose, sight_of(pose, from, to), {0.25, 0.1}), &map_lines()[k]) << k;
        // The same seen from the other end.
        EXPECT_EQ(match(pose, sight_of(pose, to, from), {0.25, 0.1}), &map_lines()[k]) << k;
    }
}

TEST(Map, WhatIsNoLineIsNotMatched) {
    const Pose2 pose{{1.0, 1.0}, 0.3};
    EXPECT_EQ(match(pose, sight_of(pose, {5.0, -3.0}, {5.0, 3.0}), {0.25, 0.1}), nullptr);
    EXPECT_EQ(match(pose, sight_of(pose, {-4.0, -9.0}, {4.0, 9.0}), {0.25, 0.1}), nullptr);
    // Along the touch line's course, but beyond its end.
    EXPECT_EQ(match(pose, sight_of(pose, {16.0, 10.0}, {19.0, 10.0}), {0.25, 0.1}), nullptr);
}

}  // namespace
}  // namespace k3d::agent::localisation
