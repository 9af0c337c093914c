// SPDX-License-Identifier: BSD-3-Clause
// The fast stepper by itself; against the exact one it is tested in tests/contract.
#include "server/physics/fast/fast_stepper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "server/body/scene.h"

namespace k3d::server {
namespace {

using physics::Stepper;

TEST(FastStepper, RefusesNumbersThatAreNotFinite) {
    body::Scene scene(Stepper::Fast);
    scene.ball.set_velocity({std::numeric_limits<double>::quiet_NaN(), 0, 0});
    EXPECT_THROW(scene.world.step(), physics::Diverged);
}

TEST(FastStepper, TakesUpARobotWhereItWasPut) {
    body::Scene scene(Stepper::Fast);
    body::Robot& robot = *scene.add_player(0, {0, 0, 0.4}).robot;
    for (int i = 0; i < 50; ++i) {
        robot.drive(nao::JointId::LShoulderPitch, -1.0);
        scene.world.step();
    }
    const double joint = robot.angle(nao::JointId::LShoulderPitch);
    robot.drive(nao::JointId::LShoulderPitch, 0.0);
    robot.place({3, -2, 0.4}, kPi / 3);
    for (int i = 0; i < 50; ++i) scene.world.step();
    EXPECT_LT((robot.torso_position() - Vec3(3, -2, 0.384)).norm(), 0.02);
    EXPECT_NEAR(robot.heading(), kPi / 3, 0.02);
    EXPECT_NEAR(robot.angle(nao::JointId::LShoulderPitch), joint, 1e-3);
}

TEST(FastStepper, RemovedPlayerLeavesNoTrace) {
    body::Scene with(Stepper::Fast);
    body::Scene without(Stepper::Fast);
    for (body::Scene* scene : {&with, &without}) scene->add_player(0, {1, 1, 0.5});
    with.remove_player(with.add_player(4, {5, 5, 0.4}).id);
    for (int i = 0; i < 20; ++i) {
        with.world.step();
        without.world.step();
    }
    EXPECT_EQ(with.world.hash(0), without.world.hash(0));
}

TEST(FastStepper, StandsStillAndFeelsItsWeight) {
    body::Scene scene(Stepper::Fast);
    body::Robot& robot = *scene.add_player(0, {0, 0, 0.4}).robot;
    for (int i = 0; i < 100; ++i) scene.world.step();
    const Vec3 before = robot.torso_position();
    Vec3 force = Vec3::Zero();
    for (int i = 0; i < 500; ++i) scene.world.step();
    for (const physics::Contact& contact : scene.world.contacts()) {
        if (contact.a->kind == physics::Kind::Robot) force += contact.force_on_a;
    }
    EXPECT_LT((robot.torso_position() - before).norm(), 1e-6);
    EXPECT_LT((force - Vec3(0, 0, 9.81 * robot.model().total_mass)).norm(), 1e-3);
}

/// One island of six robots and the ball: the pile must come to rest, not gain energy.
TEST(FastStepper, APileOfRobotsComesToRest) {
    body::Scene scene(Stepper::Fast);
    for (int n = 0; n < 6; ++n) {
        const body::Player& player = scene.add_player(n % 5, {0.05 * n, 0.1 * (n % 3), 0.4});
        player.robot->place({0.05 * n, 0.1 * (n % 3), 0.4 + 0.45 * n}, 1.3 * n);
    }
    scene.ball.move({0, 0, 3.5});
    bool joined = false;
    for (int i = 0; i < 600; ++i) {
        for (const auto& player : scene.players) {
            player->robot->drive(nao::JointId::RHipPitch, i < 200 ? 3.0 : 0.0);
        }
        scene.world.step();
        for (const physics::Contact& contact : scene.world.contacts()) {
            joined = joined || contact.b->kind == physics::Kind::Robot;
        }
    }
    EXPECT_TRUE(joined) << "robots must have touched one another";
    for (const auto& player : scene.players) {
        EXPECT_LT(player->robot->torso_velocity().norm(), 0.2);
        EXPECT_GT(player->robot->torso_position().z(), 0.03);
        EXPECT_LT(player->robot->torso_position().head<2>().norm(), 3.0);
    }
}

}  // namespace
}  // namespace k3d::server
