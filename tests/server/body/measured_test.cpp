// SPDX-License-Identifier: BSD-3-Clause
// Ball and robot against what the reference server was measured to do (tables in tests/server/measured).
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "server/body/scene.h"
#include "server/measured/table.h"
#include "server/percepts/senses.h"

namespace k3d::server {
namespace {

using k3d::testing::measured;
using k3d::testing::Row;

constexpr double kRestHeight = 0.0402764;  // of the ball, sunk a little into the ground

/// How far a ball had come after so many seconds, m for each m/s it started with.
constexpr std::pair<const char*, double> kWays[] = {
    {"0.40", 0.234739}, {"1.00", 0.443201}, {"2.00", 0.596231}};

class BallRoll : public ::testing::TestWithParam<int> {};

TEST_P(BallRoll, KeepsToTheMeasuredSpeedAndStopsWhereItStopped) {
    const double v0 = GetParam();
    const auto column = static_cast<std::size_t>(GetParam());
    body::Scene scene;
    scene.ball.move({0, 3, kRestHeight});
    scene.ball.set_velocity({v0, 0, 0});
    int cycle = 0;
    const auto step_to = [&](int target) {
        for (; cycle < target; ++cycle) scene.world.step();
    };
    for (const Row& row : measured("ball_roll.csv")) {
        if (row[0] == "end_x_m") {
            step_to(400);
            const double end = std::stod(row[column]);
            EXPECT_NEAR(scene.ball.position().x(), end, 0.03 * end);
        } else {
            step_to(static_cast<int>(std::lround(std::stod(row[0]) / 0.02)));
            EXPECT_NEAR(scene.ball.velocity().head<2>().norm(), std::stod(row[column]), 0.03 * v0)
                << "at " << row[0] << " s";
            for (const auto& [time, way] : kWays) {
                if (row[0] != time) continue;
                EXPECT_NEAR(scene.ball.position().x(), way * v0, 0.03 * way * v0) << time << " s";
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Measured, BallRoll, ::testing::Range(1, 7),
                         [](const auto& test) { return std::to_string(test.param) + "_m_s"; });

TEST(BallDrop, BouncesToTheMeasuredHeights) {
    for (const Row& row : measured("ball_drop.csv")) {
        SCOPED_TRACE("from " + row[0] + " m");
        body::Scene scene;
        scene.ball.move({0, 3, std::stod(row[0])});
        std::vector<double> heights{std::stod(row[0])};
        for (int cycle = 0; cycle < 200; ++cycle) {
            scene.world.step();
            heights.push_back(scene.ball.position().z());
        }
        std::vector<double> peaks;
        for (std::size_t i = 1; i + 1 < heights.size(); ++i) {
            if (heights[i] > heights[i - 1] && heights[i] >= heights[i + 1]) {
                peaks.push_back(heights[i]);
            }
        }
        ASSERT_GE(peaks.size(), row.size() - 2);
        for (std::size_t k = 2; k < row.size(); ++k) {
            EXPECT_NEAR(peaks[k - 2], std::stod(row[k]), 0.09 * std::stod(row[k])) << "bounce " << k - 1;
        }
        EXPECT_NEAR(heights.back(), std::stod(row[1]), 1e-4) << "at rest";
    }
}

TEST(FreeFall, EachStepFallsAsSemiImplicitEulerSays) {
    body::Scene scene;
    scene.ball.move({0, 3, 1.042});
    scene.world.step();
    EXPECT_NEAR(scene.ball.position().z(), 1.042 - 9.81 * 0.02 * 0.02, 1e-9);
    scene.world.step();
    EXPECT_NEAR(scene.ball.position().z(), 1.03026, 5e-5);  // with drag, as recorded
}

class Standing : public ::testing::TestWithParam<int> {};

TEST_P(Standing, LandsAndStandsAsMeasured) {
    const int type = GetParam();
    const auto column = static_cast<std::size_t>(type);
    body::Scene scene;
    body::Player& self = scene.add_player(type, {-5, 0, 0.4});
    percepts::Senses senses({}, RandomStream(1, "left.1", "vision"));
    wire::Percepts percepts;
    int cycle = 0;
    for (const Row& row : measured("stand.csv")) {
        for (const int target = std::stoi(row[0]); cycle < target; ++cycle) {
            senses.before_step(self);
            scene.world.step();
            senses.after_step(scene, self, 0.0, percepts);
        }
        SCOPED_TRACE("cycle " + row[0]);
        const std::string& height = row[1 + column];
        if (!height.empty()) {
            EXPECT_NEAR(self.robot->torso_position().z(), std::stod(height), 1e-4);
        }
        const double force = std::stod(row[11 + column]);
        ASSERT_TRUE(percepts.feet[1] || force == 0.0);
        if (percepts.feet[1]) {
            EXPECT_NEAR(percepts.feet[1]->force.z(), force, 0.5);
        }
        // The recorded robots were moving when they were beamed: two cycles of ACC tell of that.
        if (cycle > 2) {
            EXPECT_NEAR(percepts.acceleration.z(), std::stod(row[6 + column]), 0.1);
        }
    }
    double weight = 0.0;
    for (const auto& foot : percepts.feet) weight += foot ? foot->force.z() : 0.0;
    EXPECT_NEAR(weight, 45.18, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Measured, Standing, ::testing::Range(0, nao::kTypeCount));

TEST(Toes, OfTypeFourCarryTheirShare) {
    body::Scene scene;
    body::Player& self = scene.add_player(4, {-5, 0, 0.4});
    percepts::Senses senses({}, RandomStream(1, "left.1", "vision"));
    wire::Percepts percepts;
    for (int cycle = 0; cycle < 100; ++cycle) {
        senses.before_step(self);
        scene.world.step();
        senses.after_step(scene, self, 0.0, percepts);
    }
    for (const std::size_t foot : {0U, 1U}) {
        ASSERT_TRUE(percepts.feet[foot] && percepts.feet[foot + 2]);
        EXPECT_NEAR(percepts.feet[foot]->force.z(), 16.51, 0.1);
        EXPECT_NEAR(percepts.feet[foot + 2]->force.z(), 6.08, 0.1);
    }
}

TEST(Joints, RespondInEveryCycleAsMeasured) {
    for (const Row& row : measured("joint_response.csv")) {
        const auto joint = nao::joint_by_effector(row[0]);
        ASSERT_TRUE(joint) << row[0];
        const double command = std::stod(row[1]);
        body::Scene scene;
        body::Robot& robot = *scene.add_player(0, {-5, 0, 0.385}).robot;
        for (int i = 0; i < 50; ++i) scene.world.step();
        // To the angle of the first message, in one step.
        robot.drive(*joint, radians(std::stod(row[2])) / 0.02);
        scene.world.step();
        robot.drive(*joint, 0.0);
        for (int message = 1; message <= 14; ++message) {
            const double angle = std::stod(row[static_cast<std::size_t>(message + 1)]);
            EXPECT_NEAR(degrees(robot.angle(*joint)), angle, 0.1)
                << row[0] << " at " << row[1] << " rad/s, message " << message;
            if (message <= 8) robot.drive(*joint, command);
            if (message == 9) robot.drive(*joint, 0.0);
            scene.world.step();
        }
    }
}

TEST(Fall, OverTheAnklesTakesTheMeasuredCourse) {
    body::Scene scene;
    body::Robot& robot = *scene.add_player(0, {-5, 0, 0.4}).robot;
    for (int i = 0; i < 100; ++i) scene.world.step();
    int cycle = 0;
    for (const Row& row : measured("fall_ankle.csv")) {
        const double rate = cycle < 20 ? -1.5 : 0.0;
        robot.drive(nao::JointId::LAnklePitch, rate);
        robot.drive(nao::JointId::RAnklePitch, rate);
        scene.world.step();
        ++cycle;
        EXPECT_NEAR(robot.torso_position().z(), std::stod(row[1]), 0.01) << "at " << row[0] << " s";
    }
}

}  // namespace
}  // namespace k3d::server
