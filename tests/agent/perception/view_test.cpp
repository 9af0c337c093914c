// SPDX-License-Identifier: BSD-3-Clause
#include "agent/perception/view.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/agent/support/synthetic.h"

namespace k3d::agent::perception {
namespace {

const Identity kSelf{"Own", 1};

synthetic::Scene scene() {
    synthetic::Scene scene;
    scene.robot = {{-3.0, 1.0}, 0.4};
    scene.head_yaw = 0.5;
    return scene;
}

View view_of(const synthetic::Scene& scene, bool noise, const Quat& known_tilt) {
    View view;
    look(synthetic::Eyes(4, noise).look(scene), synthetic::body_of(scene, known_tilt), kSelf, view);
    return view;
}

TEST(View, PolarLeftAndUpArePositive) {
    EXPECT_TRUE(to_camera({2.0, 0.0, 0.0}).isApprox(Vec3(2.0, 0.0, 0.0), 1e-12));
    EXPECT_TRUE(to_camera({2.0, 90.0, 0.0}).isApprox(Vec3(0.0, 2.0, 0.0), 1e-12));
    EXPECT_TRUE(to_camera({2.0, 0.0, 30.0}).isApprox(Vec3(std::sqrt(3.0), 0.0, 1.0), 1e-12));
}

TEST(View, SightingsLieWhereTheyAreInTheRobotFrame) {
    synthetic::Scene s = scene();
    s.ball = s.robot.to_global({1.0, 0.3});
    const View view = view_of(s, false, Quat::Identity());
    ASSERT_GE(view.landmarks.size(), 2u);
    for (const LandmarkSight& sight : view.landmarks) {
        const auto& mark = field::kLandmarks[static_cast<std::size_t>(sight.landmark)];
        const Vec2 truth = s.robot.to_local({mark.x, mark.y});
        EXPECT_LT((sight.position - truth).norm(), 0.01) << mark.name;  // two decimals on the wire
    }
    ASSERT_TRUE(view.ball.has_value());
    EXPECT_LT((*view.ball - Vec3(1.0, 0.3, field::kBallRadius)).norm(), 0.01);
    EXPECT_GE(view.lines.size(), 8u);
    for (const LineSight& sight : view.lines) {
        // Both ends lie on one and the same painted line.
        double nearest = 1e9;
        for (const field::Line& line : field::lines()) {
            const Vec2 along = (line.end - line.begin).normalized();
            const Vec2 a = s.robot.to_global(sight.begin) - line.begin;
            const Vec2 b = s.robot.to_global(sight.end) - line.begin;
            nearest = std::min(nearest, std::max(std::abs(along.x() * a.y() - along.y() * a.x()),
                                                 std::abs(along.x() * b.y() - along.y() * b.x())));
        }
        EXPECT_LT(nearest, 0.02);
    }
}

TEST(View, ATiltTheBodyDoesNotKnowOfIsReadOffTheLines) {
    synthetic::Scene s = scene();
    s.ball = s.robot.to_global({0.6, 0.1});
    s.tilt = Quat(Eigen::AngleAxisd(radians(2.0), Vec3::UnitY())) *
             Quat(Eigen::AngleAxisd(radians(-1.5), Vec3::UnitX()));
    const auto body = synthetic::body_of(s, Quat::Identity());
    const View view = view_of(s, true, Quat::Identity());
    ASSERT_TRUE(view.ball.has_value());
    EXPECT_LT(view.camera_rotation.angularDistance(s.camera_rotation()), radians(0.3));
    EXPECT_GT(body.camera_rotation.angularDistance(s.camera_rotation()), radians(2.0));
    EXPECT_LT((view.ball->head<2>() - Vec2(0.6, 0.1)).norm(), 0.015);
}

TEST(View, PlayersAreTheMiddleOfTheirPartsAndFallenOnesAreTold) {
    synthetic::Scene s = scene();
    s.others = {{"Own", 2, {s.robot.to_global({2.0, 0.5}), 1.0}, false},
                {"Foe", 1, {s.robot.to_global({2.5, 1.5}), 0.0}, true}};
    const View view = view_of(s, true, Quat::Identity());
    ASSERT_EQ(view.players.size(), 2u);
    EXPECT_TRUE(view.players[0].mate);
    EXPECT_EQ(view.players[0].unum, 2);
    EXPECT_EQ(view.players[0].fallen, false);
    EXPECT_LT((view.players[0].position - Vec2(2.0, 0.5)).norm(), 0.04);
    EXPECT_FALSE(view.players[1].mate);
    EXPECT_EQ(view.players[1].fallen, true);
    EXPECT_LT((view.players[1].position - Vec2(2.5, 1.5)).norm(),
              0.35);  // it lies half a metre long
}

TEST(View, OwnArmsAreNoPlayer) {
    synthetic::Scene s = scene();
    s.own_arms = true;
    s.head_yaw = 0.0;
    s.head_pitch = -0.6;
    const wire::See see = synthetic::Eyes(1, false).look(s);
    ASSERT_EQ(see.players.size(), 1u) << "the scene must show the arms";
    View view;
    look(see, synthetic::body_of(s, Quat::Identity()), kSelf, view);
    EXPECT_TRUE(view.players.empty());
    // The same arms under another number are somebody else's.
    look(see, synthetic::body_of(s, Quat::Identity()), {"Own", 5}, view);
    EXPECT_EQ(view.players.size(), 1u);
}

TEST(View, SightingsThatAreNotFiniteAreDropped) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    wire::See see;
    see.ball = wire::Pol{nan, 0.0, 0.0};
    see.landmarks[0] = wire::Pol{10.0, nan, 0.0};
    see.lines.push_back({{5.0, 0.0, nan}, {5.0, 10.0, -5.0}});
    wire::SeenPlayer player;
    player.team = "Foe";
    player.unum = 3;
    player.head = wire::Pol{3.0, 0.0, nan};
    see.players.push_back(player);
    View view;
    look(see, synthetic::body_of(scene(), Quat::Identity()), kSelf, view);
    EXPECT_FALSE(view.ball.has_value());
    EXPECT_TRUE(view.landmarks.empty());
    EXPECT_TRUE(view.lines.empty());
    EXPECT_TRUE(view.players.empty());
    EXPECT_TRUE(view.camera_rotation.coeffs().allFinite());
}

}  // namespace
}  // namespace k3d::agent::perception
