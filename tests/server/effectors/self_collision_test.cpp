// SPDX-License-Identifier: BSD-3-Clause
// When limbs count as overlapping, what stands still then, and for how long.
#include "server/effectors/self_collision.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "common/clock/clock.h"
#include "server/body/scene.h"

namespace k3d::server::effectors {
namespace {

Box box(const Vec3& centre, const Vec3& turn) {
    Box b{centre, Mat3::Identity(), {0.05, 0.05, 0.05}};
    if (turn.norm() > 0.0) {
        b.axes = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
    }
    return b;
}

TEST(Overlap, NeedsMoreThanTheTolerance) {
    const Vec3 askew(0.7, 0.5, 0.9);  // far from parallel to the other's edges
    const Box still = box({0, 0, 0}, {0, 0, 0});
    EXPECT_TRUE(overlap(still, box({0.02, 0, 0}, askew), 0.04));
    EXPECT_FALSE(overlap(still, box({0.115, 0, 0}, askew), 0.04)) << "1 to 4 cm are forgiven";
    EXPECT_TRUE(overlap(still, box({0.115, 0, 0}, askew), 0.0));
    EXPECT_FALSE(overlap(still, box({0.3, 0, 0}, askew), 0.0));
}

TEST(Overlap, OfParallelBoxesNeverCounts) {
    EXPECT_FALSE(overlap(box({0, 0, 0}, {0, 0, 0}), box({0, 0, 0}, {0, 0, 0}), 0.04));
}

/// A robot in the air whose left leg swings through the right one.
class CrossedLegs : public ::testing::Test {
  protected:
    body::Scene scene;
    body::Robot& robot = *scene.add_player(0, {0, 5, 50}).robot;
    SelfCollision rule;
    Cycle now;

    /// Until the rule speaks; false if it never does.
    bool cross() {
        using enum nao::JointId;
        const std::vector<std::pair<nao::JointId, double>> targets{
            {LHipYawPitch, -0.8}, {LHipRoll, -0.43},    {LHipPitch, 0.8},
            {LKneePitch, -1.5},   {RHipYawPitch, -0.8}, {RHipRoll, 0.7}};
        for (int i = 0; i < 100; ++i) {
            for (const auto& [joint, target] : targets) {
                robot.drive(joint, (target - robot.angle(joint)) * 10.0);
            }
            scene.world.step();
            ++now;
            if (rule.judge(robot, now.seconds())) return true;
        }
        return false;
    }
};

TEST_F(CrossedLegs, FreezeBothLegsAndNothingElseForASecond) {
    ASSERT_TRUE(cross());
    EXPECT_TRUE(rule.frozen(nao::JointId::LHipPitch));
    EXPECT_TRUE(rule.frozen(nao::JointId::RAnkleRoll));
    EXPECT_FALSE(rule.frozen(nao::JointId::LElbow));
    EXPECT_FALSE(rule.frozen(nao::JointId::HeadYaw));
    const double foul = now.seconds();
    for (int i = 0; i < 49; ++i) {
        ++now;
        EXPECT_FALSE(rule.judge(robot, now.seconds()));
    }
    EXPECT_TRUE(rule.frozen(nao::JointId::LHipPitch));
    rule.judge(robot, foul + kFrozenTime + 1e-6);
    EXPECT_FALSE(rule.frozen(nao::JointId::LHipPitch));
    EXPECT_FALSE(rule.judge(robot, foul + kFrozenTime + kImmuneTime - 0.1)) << "immune";
    EXPECT_FALSE(rule.frozen(nao::JointId::LHipPitch));
    EXPECT_TRUE(rule.judge(robot, foul + kFrozenTime + kImmuneTime + 0.1)) << "still crossed";
    EXPECT_TRUE(rule.frozen(nao::JointId::LHipPitch));
}

TEST_F(CrossedLegs, AreFreeInAPause) {
    ASSERT_TRUE(cross());
    rule.release();
    EXPECT_FALSE(rule.frozen(nao::JointId::LHipPitch));
    ++now;
    EXPECT_TRUE(rule.judge(robot, now.seconds())) << "and freeze again when play goes on";
}

TEST(SelfCollision, AStandingRobotBreaksNoRule) {
    for (int type = 0; type < nao::kTypeCount; ++type) {
        body::Scene scene;
        body::Robot& robot = *scene.add_player(type, {-5, 0, 0.4}).robot;
        SelfCollision rule;
        for (Cycle now; now.count < 50; ++now) {
            robot.drive(nao::JointId::LShoulderPitch, -1.5);  // arms down
            robot.drive(nao::JointId::RShoulderPitch, -1.5);
            scene.world.step();
            EXPECT_FALSE(rule.judge(robot, now.seconds())) << "type " << type;
        }
    }
}

}  // namespace
}  // namespace k3d::server::effectors
