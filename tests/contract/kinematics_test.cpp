// SPDX-License-Identifier: BSD-3-Clause
// The agent's kinematics against the server's bodies, and the leg's inverse against its forward.
#include <gtest/gtest.h>

#include "agent/kinematics/leg.h"
#include "common/random/stream.h"
#include "contract/body_rig.h"

namespace k3d::contract {
namespace {

using agent::kinematics::body_to_agent;
using agent::kinematics::Leg;
using agent::kinematics::PartPoses;
using agent::kinematics::Side;
using agent::kinematics::SolePose;

class KinematicsContract : public testing::TestWithParam<int> {};

/// Greatest distance between a part in the physics and the same part by forward kinematics.
double worst_part_error(BodyRig& rig) {
    nao::JointArray angles{};
    for (const nao::JointDef& joint : rig.model().joints) {
        angles[nao::index(joint.id)] = rig.robot().angle(joint.id);
    }
    const PartPoses parts = agent::kinematics::forward(rig.model(), angles);
    const Quat to_torso = rig.robot().torso_rotation().conjugate();
    double worst = 0.0;
    for (std::size_t i = 0; i < rig.model().bodies.size(); ++i) {
        const Vec3 truth =
            body_to_agent(to_torso * (rig.robot().position(i) - rig.robot().torso_position()));
        const auto part = nao::index(rig.model().bodies[i].part);
        worst = std::max(worst, (parts[part].position - truth).norm());
    }
    return worst;
}

TEST_P(KinematicsContract, PartsAreWhereThePhysicsHasThem) {
    BodyRig rig(GetParam());
    EXPECT_LT(worst_part_error(rig), 1e-9) << "zero pose";
    RandomStream random(7, "robot", "pose");
    rig.robot().move({0, 0, 3.0});  // in the air, where no contact bends a joint
    for (int i = 0; i < 8; ++i) {
        nao::JointArray rates{};
        for (double& rate : rates) rate = random.uniform(-3.0, 3.0);
        rig.advance(rates);
    }
    for (int i = 0; i < 12; ++i) rig.advance({});  // hinges give a little while they turn fast
    EXPECT_LT(worst_part_error(rig), 1e-3) << "random pose";
}

TEST_P(KinematicsContract, LegInverseUndoesForward) {
    const nao::Model& model = nao::model(GetParam());
    RandomStream random(3, "leg", "angles");
    for (const Side side : {Side::Right, Side::Left}) {
        const Leg leg(model, side);
        int tried = 0;
        for (int i = 0; i < 2000; ++i) {
            nao::JointArray angles{};
            for (const nao::JointDef& joint : model.joints) {
                angles[nao::index(joint.id)] =
                    random.uniform(std::max(joint.min, -0.8), std::min(joint.max, 0.8));
            }
            // A straight leg and a hip beside the foot have a second solution; neither is drawn.
            const auto knee =
                side == Side::Right ? nao::JointId::RKneePitch : nao::JointId::LKneePitch;
            angles[nao::index(knee)] = random.uniform(-1.8, -0.1);
            const SolePose wanted = leg.sole(agent::kinematics::forward(model, angles));
            const Vec3 hip = wanted.rotation.transpose() * (leg.hip() - wanted.position);
            if (hip.z() < 0.1) continue;
            ++tried;
            nao::JointArray solved = angles;
            ASSERT_TRUE(leg.solve(wanted, solved));
            const SolePose reached = leg.sole(agent::kinematics::forward(model, solved));
            ASSERT_LT((reached.position - wanted.position).norm(), 1e-9);
            ASSERT_LT((reached.rotation - wanted.rotation).norm(), 1e-9);
        }
        EXPECT_GT(tried, 500);
    }
}

TEST_P(KinematicsContract, OutOfReachStretchesTheLegTowardsTheTarget) {
    const nao::Model& model = nao::model(GetParam());
    const Leg leg(model, Side::Left);
    SolePose wanted = leg.zero_pose();
    wanted.position.z() -= 0.05;
    nao::JointArray solved{};
    EXPECT_FALSE(leg.solve(wanted, solved));
    const SolePose reached = leg.sole(agent::kinematics::forward(model, solved));
    EXPECT_NEAR(reached.position.z(), leg.zero_pose().position.z(), 0.002);
}

INSTANTIATE_TEST_SUITE_P(Types, KinematicsContract, testing::Range(0, nao::kTypeCount));

}  // namespace
}  // namespace k3d::contract
