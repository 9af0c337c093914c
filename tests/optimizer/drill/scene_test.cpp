// SPDX-License-Identifier: BSD-3-Clause
// The monitor stream's reader on frames composed by hand.
#include "optimizer/drill/scene.h"

#include <gtest/gtest.h>

namespace k3d::optimizer::drill {
namespace {

/// Ball at (1, 2), a robot of the right team with number 1, and ours at (-3, 4), looking along +y;
/// its body's mesh stands in a transform of its own, as on the wire.
const std::string kFull =
    "((play_modes BeforeKickOff PlayOn)(time 1.5)(play_mode 1))(RSG 0 1)("
    "(nd Light (setDiffuse 1 1 1 1))"
    "(nd TRF (SLT 1 0 0 0 0 1 0 0 0 0 1 0 1 2 0.04 1)"
    "(nd StaticMesh (setVisible 1) (load models/soccerball.obj) (sSc 1 1 1)))"
    "(nd TRF (SLT 1 0 0 0 0 1 0 0 0 0 1 0 9 9 9 1)"
    "(nd StaticMesh (setVisible 1) (load models/naobody0.obj) (resetMaterials matNum1 matRight)))"
    "(nd TRF (SLT 1 0 0 0 0 1 0 0 0 0 1 0 -3 4 0.38 1)"
    "(nd TRF (SLT -1 0 0 0 0 0 1 0 0 1 0 0 0 0 0 1)"
    "(nd StaticMesh (setVisible 1) (load models/naobody0.obj) (resetMaterials matNum1 matLeft)))))";

TEST(Scene, ReadsAFullFrame) {
    Scene scene;
    const Truth& truth = scene.read(kFull);
    EXPECT_EQ(truth.time, 1.5);
    EXPECT_EQ(truth.play_mode, "PlayOn");
    EXPECT_LT((truth.ball - Vec3(1, 2, 0.04)).norm(), 1e-12);
    ASSERT_TRUE(truth.robot);
    EXPECT_LT((truth.robot->torso - Vec3(-3, 4, 0.38)).norm(), 1e-12);
    EXPECT_NEAR(truth.robot->pose.yaw, kPi / 2.0, 1e-12);
    EXPECT_NEAR(truth.robot->up, 1.0, 1e-12);
}

TEST(Scene, ADifferenceChangesOnlyWhatItTells) {
    Scene scene;
    scene.read(kFull);
    // The robot fell on its back: its upward axis (the third) points along -y.
    const Truth& truth = scene.read(
        "((time 1.54)(play_mode 0))(RDS 0 1)((nd)"
        "(nd (SLT 1 0 0 0 0 1 0 0 0 0 1 0 1.5 2 0.04 1)(nd StaticMesh))"
        "(nd(nd StaticMesh))(nd (SLT 1 0 0 0 0 0 1 0 0 -1 0 0 -3 4 0.1 1)(nd(nd StaticMesh))))");
    EXPECT_EQ(truth.time, 1.54);
    EXPECT_EQ(truth.play_mode, "BeforeKickOff");
    EXPECT_EQ(truth.ball.x(), 1.5);
    ASSERT_TRUE(truth.robot);
    EXPECT_NEAR(truth.robot->up, 0.0, 1e-12);
    EXPECT_EQ(truth.robot->torso.z(), 0.1);
}

TEST(Scene, ADifferenceBeforeTheFirstFullFrameShowsNobody) {
    Scene scene;
    const Truth& truth = scene.read("((time 3))(RDS 0 1)((nd)(nd(nd StaticMesh)))");
    EXPECT_EQ(truth.time, 3.0);
    EXPECT_FALSE(truth.robot);
}

TEST(Scene, DamagedFramesAreRefused) {
    for (const char* damaged :
         {"", "((time 1))", "((time 1))(XYZ 0 1)((nd))", "((time x))(RSG 0 1)((nd))",
          "((play_modes A B)(play_mode 2))(RSG 0 1)((nd))", "((time 1))(RSG 0 1)((nd)",
          "((time 1))(RSG 0 1)((nd TRF (SLT 1 0 0)))"}) {
        Scene scene;
        EXPECT_THROW(scene.read(damaged), SceneError) << damaged;
    }
    Scene scene;
    scene.read(kFull);
    EXPECT_THROW(scene.read("((time 2))(RDS 0 1)((nd)(nd))"), SceneError) << "nodes are missing";
    EXPECT_THROW(scene.read("((time 2))(RDS 0 1)((nd)(nd)(nd)(nd)(nd)(nd)(nd)(nd)(nd)(nd)(nd))"),
                 SceneError)
        << "too many nodes";
}

}  // namespace
}  // namespace k3d::optimizer::drill
