// SPDX-License-Identifier: BSD-3-Clause
#include "agent/perception/body_sense.h"

#include <gtest/gtest.h>

namespace k3d::agent::perception {
namespace {

wire::Percepts standing() {
    wire::Percepts percepts;
    percepts.time = 3.2;
    percepts.gyro_deg = {90.0, 180.0, -45.0};  // about right, forward, up
    percepts.acceleration = {1.0, 2.0, 9.81};
    return percepts;
}

TEST(BodySense, TurnsWireAxesAndDegreesIntoAgentAxesAndRadians) {
    motion::BodySense sense;
    body_sense(standing(), sense);
    EXPECT_DOUBLE_EQ(sense.time, 3.2);
    // Wire forward (y) is agent x; wire right (x) is minus agent left (y).
    EXPECT_TRUE(sense.gyro.isApprox(Vec3(kPi, -kPi / 2.0, -kPi / 4.0), 1e-12));
    EXPECT_TRUE(sense.acceleration.isApprox(Vec3(2.0, -1.0, 9.81), 1e-12));
}

TEST(BodySense, KeepsTheAngleOfAJointThatIsNotReported) {
    const std::size_t knee = index(nao::JointId::RKneePitch);
    const std::size_t head = index(nao::JointId::HeadYaw);
    wire::Percepts percepts = standing();
    percepts.joints_deg[knee] = -90.0;
    percepts.has_joint[knee] = true;
    motion::BodySense sense;
    sense.joints[head] = 0.25;
    body_sense(percepts, sense);
    EXPECT_NEAR(sense.joints[knee], -kPi / 2.0, 1e-12);
    EXPECT_DOUBLE_EQ(sense.joints[head], 0.25);
}

TEST(BodySense, ASoleWithoutPerceptHasNoContact) {
    wire::Percepts percepts = standing();
    percepts.feet[static_cast<std::size_t>(wire::FootSensor::Left)] =
        wire::FootForce{{0.01, 0.05, -0.01}, {1.0, -2.0, 22.6}};
    motion::BodySense sense;
    sense.right_sole = motion::SoleForce{};  // of the frame before
    body_sense(percepts, sense);
    EXPECT_FALSE(sense.right_sole.has_value());
    ASSERT_TRUE(sense.left_sole.has_value());
    EXPECT_TRUE(sense.left_sole->point.isApprox(Vec3(0.05, -0.01, -0.01), 1e-12));
    EXPECT_TRUE(sense.left_sole->force.isApprox(Vec3(-2.0, -1.0, 22.6), 1e-12));
}

}  // namespace
}  // namespace k3d::agent::perception
