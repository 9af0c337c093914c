// SPDX-License-Identifier: BSD-3-Clause
#include "agent/perception/level.h"

#include <gtest/gtest.h>

#include <vector>

namespace k3d::agent::perception {
namespace {

TEST(Level, NoGroundNoCorrection) {
    EXPECT_DOUBLE_EQ(level({}, 0.54).angularDistance(Quat::Identity()), 0.0);
}

TEST(Level, UndoesATilt) {
    const Quat tilt(Eigen::AngleAxisd(radians(2.0), Vec3(0.6, -0.8, 0.0)));
    std::vector<Vec3> ground;
    for (const double x : {1.0, 4.0, 9.0}) {
        for (const double y : {-3.0, 0.0, 5.0}) ground.push_back(tilt * Vec3(x, y, -0.54));
    }
    const Quat correction = level(ground, 0.54);
    EXPECT_LT((correction * tilt).angularDistance(Quat::Identity()), radians(0.1));
}

TEST(Level, ACameraTooHighIsNotTakenForATilt) {
    std::vector<Vec3> ground;
    for (const double x : {1.0, 4.0, 9.0}) {
        for (const double y : {-3.0, 0.0, 5.0}) ground.push_back({x, y, -0.54});
    }
    EXPECT_LT(level(ground, 0.52).angularDistance(Quat::Identity()), radians(0.1));
}

TEST(Level, AnImplausibleTiltIsLeftAlone) {
    const Quat tilt(Eigen::AngleAxisd(radians(40.0), Vec3::UnitY()));
    std::vector<Vec3> ground;
    for (const double x : {1.0, 4.0, 9.0}) ground.push_back(tilt * Vec3(x, 1.0, -0.54));
    EXPECT_DOUBLE_EQ(level(ground, 0.54).angularDistance(Quat::Identity()), 0.0);
}

}  // namespace
}  // namespace k3d::agent::perception
