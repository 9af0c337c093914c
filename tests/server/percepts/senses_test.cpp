// SPDX-License-Identifier: BSD-3-Clause
// A standing robot's senses, and the rhythm of See.
#include "server/percepts/senses.h"

#include <gtest/gtest.h>

namespace k3d::server::percepts {
namespace {

TEST(Senses, StandingRobotFeelsItsWeightAndGravity) {
    body::Scene scene;
    body::Player& self = scene.add_player(0, {2, 0, 0.4});
    self.team = wire::Side::Left;
    Senses senses({}, RandomStream(1, "left.1", "vision"));
    wire::Percepts percepts;
    int seen = 0;
    for (int cycle = 0; cycle < 150; ++cycle) {
        senses.before_step(self);
        scene.world.step();
        senses.after_step(scene, self, 0.02 * cycle, percepts);
        if (percepts.see) {
            EXPECT_EQ(cycle % 3, 0) << "See comes every third cycle";
            ++seen;
        }
    }
    EXPECT_EQ(seen, 50);
    EXPECT_NEAR(self.robot->torso_position().z(), 0.385, 0.005);
    ASSERT_TRUE(percepts.feet[0] && percepts.feet[1]);
    EXPECT_NEAR(percepts.feet[0]->force.z() + percepts.feet[1]->force.z(), 45.2, 0.3);
    EXPECT_NEAR(percepts.feet[0]->point.z(), -0.01, 0.003);
    EXPECT_NEAR(percepts.acceleration.z(), 9.81, 0.05);
    EXPECT_NEAR(percepts.acceleration.head<2>().norm(), 0.0, 0.05);
    EXPECT_NEAR(percepts.gyro_deg.norm(), 0.0, 0.1);
    EXPECT_EQ(percepts.has_joint.count(), 22U);
}

TEST(Senses, FallingRobotFeelsNoWeight) {
    body::Scene scene;
    body::Player& self = scene.add_player(4, {0, 0, 3.0});
    Senses senses({}, RandomStream(1, "left.1", "vision"));
    wire::Percepts percepts;
    for (int cycle = 0; cycle < 10; ++cycle) {
        senses.before_step(self);
        scene.world.step();
        senses.after_step(scene, self, 0.0, percepts);
    }
    EXPECT_NEAR(percepts.acceleration.norm(), 0.0, 0.1);
    for (const auto& foot : percepts.feet) EXPECT_FALSE(foot) << "absent, not zero";
    EXPECT_EQ(percepts.has_joint.count(), 24U) << "type 4 has toes";
}

}  // namespace
}  // namespace k3d::server::percepts
