// SPDX-License-Identifier: BSD-3-Clause
#include "agent/motion/joint_control.h"

#include <gtest/gtest.h>


namespace k3d::agent::motion {
namespace {

using nao::JointId;

/// Ideal motors behind the wire: a reply drives the step after the running one.
class DelayedJoints {
  public:
    nao::JointArray angle{};

    void reply(const nao::JointArray& rates) {
        for (std::size_t i = 0; i < rates.size(); ++i) angle[i] += running_[i] * 0.02;
        running_ = rates;
    }

  private:
    nao::JointArray running_{};
};

TEST(JointControl, ReachesANearTargetInTheFirstCycleItCan) {
    JointControl control(nao::model(0));
    DelayedJoints joints;
    JointTargets targets;
    targets[JointId::LKneePitch] = -0.1;
    nao::JointArray rates{};
    control.step(joints.angle, targets, rates);
    joints.reply(rates);  // the running step still has the old speed
    EXPECT_DOUBLE_EQ(joints.angle[index(JointId::LKneePitch)], 0.0);
    control.step(joints.angle, targets, rates);
    joints.reply(rates);
    EXPECT_NEAR(joints.angle[index(JointId::LKneePitch)], -0.1, 1e-12);
    control.step(joints.angle, targets, rates);
    joints.reply(rates);
    EXPECT_NEAR(joints.angle[index(JointId::LKneePitch)], -0.1, 1e-12) << "overshoot";
}

TEST(JointControl, FollowsARampOneCycleBehindWithoutError) {
    JointControl control(nao::model(0));
    DelayedJoints joints;
    JointTargets targets;
    nao::JointArray rates{};
    double before = 0.0;
    for (int i = 0; i < 40; ++i) {
        targets[JointId::HeadYaw] = 0.02 * i;
        control.step(joints.angle, targets, rates);
        joints.reply(rates);
        if (i > 0) {
            EXPECT_NEAR(joints.angle[index(JointId::HeadYaw)], before, 1e-12);
        }
        before = targets[JointId::HeadYaw];
    }
}

TEST(JointControl, KeepsToTopSpeedAndStops) {
    for (const int type : {0, 2, 4}) {
        const nao::Model& model = nao::model(type);
        JointControl control(model);
        DelayedJoints joints;
        JointTargets targets;
        targets.angle.fill(10.0);
        nao::JointArray rates{};
        for (int i = 0; i < 60; ++i) {
            control.step(joints.angle, targets, rates);
            for (const nao::JointDef& joint : model.joints) {
                EXPECT_LE(std::abs(rates[index(joint.id)]), joint.max_rate);
            }
            joints.reply(rates);
        }
        for (const nao::JointDef& joint : model.joints) {
            EXPECT_LT(joints.angle[index(joint.id)], joint.max);
            EXPECT_GT(joints.angle[index(joint.id)], joint.max - 0.02);
        }
    }
}

TEST(JointControl, JointsThatTheTypeLacksGetNoSpeed) {
    JointControl control(nao::model(0));
    JointTargets targets;
    targets.angle.fill(0.5);
    nao::JointArray rates{};
    control.step({}, targets, rates);
    EXPECT_EQ(rates[index(JointId::RToe)], 0.0);
    EXPECT_EQ(rates[index(JointId::LToe)], 0.0);
}

}  // namespace
}  // namespace k3d::agent::motion
