// SPDX-License-Identifier: BSD-3-Clause
// The Nao: stance, joints and placing, against the measured reference.
#include "server/body/robot.h"

#include <gtest/gtest.h>

#include <array>

#include "server/body/scene.h"

namespace k3d::server::body {
namespace {

TEST(Robot, EveryTypeStandsAtItsMeasuredHeight) {
    constexpr std::array<double, nao::kTypeCount> kMeasured{0.3839, 0.4205, 0.3839, 0.4396, 0.3839};
    for (int type = 0; type < nao::kTypeCount; ++type) {
        Scene scene;
        Robot& robot = *scene.add_player(type, {0, 0, 0.4}).robot;
        for (int i = 0; i < 100; ++i) scene.world.step();
        EXPECT_NEAR(robot.torso_position().z(), kMeasured[static_cast<std::size_t>(type)], 5e-4)
            << "type " << type;
    }
}

TEST(Robot, JointTurnsByTheCommandedRateFromTheFirstStep) {
    Scene scene;
    Robot& robot = *scene.add_player(0, {0, 0, 0.385}).robot;
    robot.drive(nao::JointId::HeadYaw, 1.0);
    for (int i = 1; i <= 5; ++i) {
        scene.world.step();
        EXPECT_NEAR(degrees(robot.angle(nao::JointId::HeadYaw)), 1.146 * i, 0.02);
    }
    const Vec3 looks = robot.rotation(2) * Vec3::UnitY();
    EXPECT_LT(looks.x(), 0.0) << "a positive neck yaw looks left";
}

TEST(Robot, RateIsClampedToTheJointsTopSpeed) {
    Scene scene;
    Robot& robot = *scene.add_player(2, {0, 0, 1.0}).robot;  // fast ankle pitch
    robot.drive(nao::JointId::LAnklePitch, 20.0);
    scene.world.step();
    EXPECT_NEAR(degrees(robot.angle(nao::JointId::LAnklePitch)), 10.09, 0.05);
    robot.drive(nao::JointId::HeadYaw, 100.0);
    scene.world.step();
    EXPECT_NEAR(degrees(robot.angle(nao::JointId::HeadYaw)), 7.035, 0.05);
}

TEST(Robot, CommandOutsideTheStopsIsIgnored) {
    Scene scene;
    Robot& robot = *scene.add_player(0, {0, 0, 0.385}).robot;
    robot.drive(nao::JointId::LElbow, 3.0);  // upper stop at 1 degree
    double highest = 0.0;
    for (int i = 0; i < 60; ++i) {
        robot.drive(nao::JointId::LElbow, 3.0);
        scene.world.step();
        highest = std::max(highest, degrees(robot.angle(nao::JointId::LElbow)));
    }
    EXPECT_GT(highest, 1.0);   // overshoots by up to a step ...
    EXPECT_LT(highest, 1.0 + 3.5);  // ... and never runs away
}

TEST(Robot, NonFiniteRateChangesNothing) {
    Scene scene;
    Robot& robot = *scene.add_player(0, {0, 0, 0.385}).robot;
    robot.drive(nao::JointId::HeadYaw, std::numeric_limits<double>::quiet_NaN());
    scene.world.step();
    EXPECT_NEAR(robot.angle(nao::JointId::HeadYaw), 0.0, 1e-6);
}

TEST(Robot, PlacingTurnsItUprightAndKeepsItsJoints) {
    Scene scene;
    Robot& robot = *scene.add_player(0, {0, 0, 0.6}).robot;
    robot.drive(nao::JointId::LShoulderPitch, -2.0);
    for (int i = 0; i < 40; ++i) scene.world.step();
    const double joint = robot.angle(nao::JointId::LShoulderPitch);
    robot.place({3, -2, 0.5}, kPi / 3);
    EXPECT_NEAR(robot.heading(), kPi / 3, 1e-9);
    EXPECT_NEAR((robot.torso_rotation() * Vec3::UnitZ()).z(), 1.0, 1e-12);
    EXPECT_TRUE(robot.torso_position().isApprox(Vec3(3, -2, 0.5)));
    EXPECT_NEAR(robot.angle(nao::JointId::LShoulderPitch), joint, 1e-9);
    EXPECT_EQ(robot.torso_velocity(), Vec3::Zero());
}

TEST(Scene, RemovedPlayerLeavesNoTrace) {
    Scene with;
    Scene without;
    const int id = with.add_player(0, {5, 5, 0.4}).id;
    with.remove_player(id);
    EXPECT_EQ(with.find(id), nullptr);
    for (int i = 0; i < 20; ++i) {
        with.world.step();
        without.world.step();
    }
    EXPECT_EQ(with.world.hash(0), without.world.hash(0));
}

}  // namespace
}  // namespace k3d::server::body
