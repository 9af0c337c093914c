// SPDX-License-Identifier: BSD-3-Clause
// The camera: noise as measured, edge of the view, and what is left out.
#include "server/percepts/vision.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/field/field.h"

namespace k3d::server::percepts {
namespace {

/// Mean and standard deviation of a series.
struct Series {
    double sum = 0.0, squares = 0.0;
    int n = 0;
    void add(double x) {
        sum += x;
        squares += x * x;
        ++n;
    }
    double mean() const { return sum / n; }
    double sd() const { return std::sqrt(std::max(0.0, squares / n - mean() * mean())); }
};

/// A player of the left team at the left penalty line, looking along +x.
class Vision : public ::testing::Test {
  protected:
    Vision() : self(scene.add_player(0, {0, 0, 1})) {
        self.team = wire::Side::Left;
        self.unum = 1;
        self.team_name = "Reds";
        self.robot->place({-7, 0, 0.385}, 0.0);
    }
    wire::See look(const VisionConfig& config) {
        wire::See see;
        Camera(config, RandomStream(1, "left.1", "vision")).see(scene, self, see);
        return see;
    }
    body::Scene scene;
    body::Player& self;
};

TEST_F(Vision, NoiseHasTheReferencesDeviations) {
    Camera camera({}, RandomStream(3, "left.1", "vision"));
    Series distance, theta, phi;
    wire::See see;
    for (int frame = 0; frame < 10000; ++frame) {
        camera.see(scene, self, see);
        const auto& pol = see.landmarks[static_cast<std::size_t>(field::Landmark::F1R)];
        ASSERT_TRUE(pol);
        distance.add(pol->distance);
        theta.add(pol->theta_deg);
        phi.add(pol->phi_deg);
    }
    EXPECT_NEAR(distance.sd() / distance.mean(), 0.000965, 0.00003);
    EXPECT_NEAR(theta.sd(), 0.1480, 0.004);
    EXPECT_NEAR(phi.sd(), 0.1225, 0.004);
    const double true_distance = Vec3(22, 10, -0.54).norm();
    EXPECT_NEAR(distance.mean(), true_distance, 0.01);  // calibration: at most 5 mm per axis
}

TEST_F(Vision, WithoutNoiseTheBallIsWhereItIs) {
    scene.ball.move({-5, 1, 0.042});
    const wire::See see = look({.noise = false});
    ASSERT_TRUE(see.ball);
    EXPECT_NEAR(see.ball->distance, Vec3(2, 1, 0.042 - 0.54).norm(), 1e-9);
    EXPECT_NEAR(see.ball->theta_deg, degrees(std::atan2(1, 2)), 1e-9) << "left is positive";
    EXPECT_LT(see.ball->phi_deg, 0.0);
}

TEST_F(Vision, ThePlayerSeesItsOwnArmsButNotItsHead) {
    const wire::See see = look({});
    ASSERT_EQ(see.players.size(), 1U);
    EXPECT_EQ(see.players[0].unum, 1);
    EXPECT_FALSE(see.players[0].head);
    EXPECT_TRUE(see.players[0].rlowerarm);
    EXPECT_TRUE(see.players[0].llowerarm);
}

TEST_F(Vision, RobotsWithoutATeamAreNotSeen) {
    scene.add_player(0, {-4, 0, 0.4});
    EXPECT_EQ(look({}).players.size(), 1U);
    body::Player& other = *scene.players.back();
    other.team = wire::Side::Right;
    other.unum = 7;
    other.team_name = "Blues";
    const wire::See see = look({});
    ASSERT_EQ(see.players.size(), 2U);
    EXPECT_EQ(see.players[1].team, "Blues");
}

TEST_F(Vision, NothingOutsideSixtyDegreesIsSeen) {
    scene.ball.move({-7 + 1.0, std::tan(radians(59.0)), 0.54});
    EXPECT_TRUE(look({.noise = false}).ball);
    scene.ball.move({-7 + 1.0, std::tan(radians(61.0)), 0.54});
    EXPECT_FALSE(look({.noise = false}).ball);
    scene.ball.move({-9, 0, 0.042});
    EXPECT_FALSE(look({}).ball) << "behind";
    scene.ball.move({-7 + 0.09, 0, 0.54});
    EXPECT_FALSE(look({}).ball) << "nearer than 0.1 m";
}

TEST_F(Vision, LinesEndInsideTheView) {
    const wire::See see = look({.noise = false});
    EXPECT_GE(see.lines.size(), 15U);  // 17 were recorded from this spot on the reference server
    for (const wire::SeenLine& line : see.lines) {
        for (const wire::Pol& end : {line.begin, line.end}) {
            EXPECT_LE(std::abs(end.theta_deg), 60.0 + 1e-5);
            EXPECT_LE(std::abs(end.phi_deg), 60.0 + 1e-5);
        }
    }
}

TEST_F(Vision, GroundTruthIsSentOnlyWhenAskedFor) {
    const wire::See plain = look({});
    EXPECT_FALSE(plain.my_position || plain.my_orientation_deg || plain.ball_position);
    const wire::See one = look({.my_orientation = true});
    EXPECT_TRUE(one.my_orientation_deg);
    EXPECT_FALSE(one.my_position || one.ball_position) << "each has its own switch";
    self.team = wire::Side::Right;
    const wire::See see = look({.my_position = true, .my_orientation = true, .ball_position = true});
    ASSERT_TRUE(see.my_position && see.my_orientation_deg && see.ball_position);
    EXPECT_NEAR(see.my_position->x(), 7.0, 1e-9) << "the right team sees the field turned";
    EXPECT_NEAR(std::abs(*see.my_orientation_deg), 180.0, 1e-6);
}

TEST(Clipping, KeepsALineWhoseEndsAreBothInView) {
    Vec3 begin(0, 1, 0);
    Vec3 end(0, 5, 0);
    EXPECT_TRUE(clip_to_view(begin, end));
    EXPECT_EQ(begin, Vec3(0, 1, 0));
    EXPECT_EQ(end, Vec3(0, 5, 0));
    // 45 degrees to the side and 58 down: outside the pyramid, yet no angle is beyond 60 degrees.
    const Vec3 corner(-1, 1, -std::sqrt(2.0) * std::tan(radians(58.0)));
    begin = corner;
    EXPECT_TRUE(clip_to_view(begin, end));
    EXPECT_EQ(begin, corner);
}

TEST(Clipping, CutsAnUnseenEndAtThePyramid) {
    const double slope = std::tan(radians(60.0));
    Vec3 begin(-10, 1, 0);
    Vec3 end(0, 1, 0);
    EXPECT_TRUE(clip_to_view(begin, end));
    EXPECT_NEAR(begin.x(), -slope, 1e-9);
    EXPECT_EQ(end, Vec3(0, 1, 0));
    begin = {0, 3, -0.5};
    end = {0, -5, -0.5};  // runs under the camera to behind it
    EXPECT_TRUE(clip_to_view(begin, end));
    EXPECT_EQ(begin, Vec3(0, 3, -0.5));
    EXPECT_NEAR(end.y(), 0.5 / slope, 1e-9);
}

TEST(Clipping, TellsALineThatCrossesTheViewFromTopToBottomAndLeftToRight) {
    const double slope = std::tan(radians(60.0));
    Vec3 begin(10, 1, 0);
    Vec3 end(-10, 1, 0);
    EXPECT_TRUE(clip_to_view(begin, end));
    EXPECT_NEAR(begin.x(), -slope, 1e-9) << "turned round";
    EXPECT_NEAR(end.x(), slope, 1e-9);
}

TEST(Clipping, LeavesOutWhatIsNotSeen) {
    Vec3 begin(0, -5, 0);
    Vec3 end(1, -1, 0);
    EXPECT_FALSE(clip_to_view(begin, end)) << "behind";
    begin = {-10, 1, 0};
    end = {-10, 2, 0};
    EXPECT_FALSE(clip_to_view(begin, end)) << "beside";
}

}  // namespace
}  // namespace k3d::server::percepts
