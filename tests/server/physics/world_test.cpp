// SPDX-License-Identifier: BSD-3-Clause
// The physics against what was measured on the reference server (lock-step, exact positions).
#include "server/physics/world.h"

#include <gtest/gtest.h>

#include <limits>

#include "server/body/scene.h"

namespace k3d::server {
namespace {

TEST(Surface, MixesAsTheReferenceTable) {
    using namespace physics;
    const Surface ball_ground = mixed(kBallSurface, kGround);
    EXPECT_DOUBLE_EQ(*ball_ground.bounce, 0.8);
    EXPECT_DOUBLE_EQ(*ball_ground.slip, 0.3025);
    EXPECT_DOUBLE_EQ(*ball_ground.soft_erp, 0.35);
    EXPECT_DOUBLE_EQ(*ball_ground.soft_cfm, 0.05);
    const Surface ball_robot = mixed(kBallSurface, kRobotSurface);
    EXPECT_DOUBLE_EQ(*ball_robot.soft_erp, 0.55);
    EXPECT_DOUBLE_EQ(*ball_robot.soft_cfm, 0.02505);
    const Surface robot_ground = mixed(kRobotSurface, kGround);
    EXPECT_FALSE(robot_ground.bounce);
    EXPECT_DOUBLE_EQ(*robot_ground.soft_erp, 0.4);
    EXPECT_DOUBLE_EQ(*mixed(kBallSurface, kSolidSurface).bounce_velocity, 1.4);
}

TEST(Ball, SpeedFallsToAThirdInASecondOfRolling) {
    body::Scene scene;
    scene.ball.set_velocity({1, 0, 0});
    for (int i = 0; i < 10; ++i) scene.world.step();
    const double rolling = scene.ball.velocity().x();
    for (int i = 0; i < 50; ++i) scene.world.step();
    EXPECT_NEAR(scene.ball.velocity().x() / rolling, 0.35, 0.01);
}

TEST(World, RefusesNumbersThatAreNotFinite) {
    body::Scene scene;
    scene.ball.set_velocity({std::numeric_limits<double>::quiet_NaN(), 0, 0});
    EXPECT_THROW(
        {
            for (int i = 0; i < 3; ++i) scene.world.step();
        },
        physics::Diverged);
}

TEST(World, RefusesSpeedsThatNoMatchKnows) {
    body::Scene scene;
    scene.ball.set_velocity({2e5, 0, 0});
    EXPECT_THROW(
        {
            for (int i = 0; i < 10; ++i) scene.world.step();
        },
        physics::Diverged);
}

TEST(World, TakesOrRefusesEveryPlaceATrainerCanName) {
    for (const double height : {-1000.0, -1.0, 0.0, 1000.0}) {
        for (const double aside : {0.0, 15.0, 1000.0}) {
            body::Scene scene;
            body::Player& player = scene.add_player(0, {aside, 0, 0.4});
            player.robot->move({aside, aside, height});
            scene.ball.move({aside, aside, height});
            scene.ball.set_velocity({0, 1000, -1000});
            try {
                for (int i = 0; i < 50; ++i) scene.world.step();
                EXPECT_TRUE(player.robot->torso_position().allFinite());
            } catch (const physics::Diverged&) {
                SUCCEED() << "a clear end, too";
            }
        }
    }
}

TEST(World, HashTellsStatesApart) {
    body::Scene one;
    body::Scene same;
    body::Scene other;
    other.ball.move({0.001, 0, 0.042});
    EXPECT_EQ(one.world.hash(7), same.world.hash(7));
    EXPECT_NE(one.world.hash(7), other.world.hash(7));
    EXPECT_NE(one.world.hash(7), one.world.hash(8));
}

}  // namespace
}  // namespace k3d::server
