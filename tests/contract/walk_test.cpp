// SPDX-License-Identifier: BSD-3-Clause
// The body in the server's physics: it stands, walks in every direction, stops, changes its mind
// and does not fall; and what it tells about itself is true.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "agent/motion/body_motion.h"
#include "common/random/stream.h"
#include "contract/body_rig.h"

namespace k3d::contract {
namespace {

using agent::motion::Activity;
using agent::motion::BodyMotion;
using agent::motion::Config;
using agent::motion::Request;
using agent::motion::Stand;
using agent::motion::State;
using agent::motion::Walk;

/// A robot with its motion; run() repeats one request.
struct Walker {
    explicit Walker(int type = 0, const Config& config = {})
        : rig(type), motion(rig.model(), config) {}

    void run(double seconds, const Request& request) {
        for (double t = 0.0; t < seconds - 1e-9; t += 0.02) {
            const State& state = motion.step(rig.sense(), request, rates);
            odometry = odometry.then(state.odometry);
            rig.advance(rates);
            worst_tilt = std::max(worst_tilt, rig.tilt());
            lean_low = std::min(lean_low, motion.posture().pitch);
            lean_high = std::max(lean_high, motion.posture().pitch);
        }
    }

    BodyRig rig;
    BodyMotion motion;
    nao::JointArray rates{};
    Pose2 odometry;
    double worst_tilt = 0.0;
    double lean_low = 1.0, lean_high = -1.0;
};

Request walk(double forward, double left, double turn) {
    return {.body = Walk{forward, left, turn}, .head = {}};
}

class EveryType : public testing::TestWithParam<int> {};

TEST_P(EveryType, StandsQuietly) {
    Walker robot(GetParam());
    robot.run(2.0, {});
    const Pose2 before = robot.rig.pose();
    robot.run(8.0, {});
    EXPECT_LT((robot.rig.pose().position - before.position).norm(), 0.01);
    EXPECT_LT(robot.worst_tilt, radians(12));
    EXPECT_EQ(robot.motion.state().activity, Activity::Standing);
}

TEST_P(EveryType, WalksAndStopsWithoutAFall) {
    Walker robot(GetParam());
    robot.run(1.0, {});
    robot.run(4.0, walk(0.4, 0, 0));
    robot.run(2.0, walk(0, 0.1, 0.8));
    robot.run(2.0, walk(-0.2, 0, 0));
    robot.run(2.0, {});
    EXPECT_EQ(robot.motion.state().falls, 0);
    EXPECT_EQ(robot.motion.state().activity, Activity::Standing);
    EXPECT_GT(robot.rig.pose().position.norm(), 0.5);
}

INSTANTIATE_TEST_SUITE_P(Types, EveryType, testing::Range(0, nao::kTypeCount));

TEST(WalkContract, CrossesTenMetresForwardInALine) {
    Walker robot;
    robot.rig.robot().place({-8.0, 0.0, robot.rig.model().standing_height}, 0.0);
    robot.run(1.0, {});
    double seconds = 0.0;
    while (robot.rig.pose().position.x() < 2.0 && seconds < 20.0) {
        robot.run(0.1, walk(2.0, 0, 0));
        seconds += 0.1;
    }
    EXPECT_LT(seconds, 10.0 / 0.75) << "speed from standing below 0.75 m/s";
    EXPECT_EQ(robot.motion.state().falls, 0);
    EXPECT_NEAR(robot.rig.pose().position.y(), 0.0, 1.0);
    EXPECT_NEAR(robot.rig.pose().yaw, 0.0, radians(10));
    // The camera rides on the torso.
    EXPECT_LT(robot.lean_high - robot.lean_low, radians(20));
}

TEST(WalkContract, WalksBackward) {
    Walker robot;
    robot.run(1.0, {});
    robot.run(6.0, walk(-2.0, 0, 0));
    EXPECT_LT(robot.rig.pose().position.x(), -0.45 * 5.5);
    EXPECT_EQ(robot.motion.state().falls, 0);
}

TEST(WalkContract, WalksSidewaysBothWays) {
    for (const double side : {1.0, -1.0}) {
        Walker robot;
        robot.run(1.0, {});
        robot.run(6.0, walk(0, 2.0 * side, 0));
        EXPECT_GT(side * robot.rig.pose().position.y(), 0.28 * 5.5);
        EXPECT_EQ(robot.motion.state().falls, 0);
    }
}

TEST(WalkContract, TurnsBothWaysOnTheSpot) {
    for (const double side : {1.0, -1.0}) {
        Walker robot;
        robot.run(1.0, {});
        double turned = 0.0;
        for (int i = 0; i < 50; ++i) {
            const double before = robot.rig.pose().yaw;
            robot.run(0.1, walk(0, 0, 4.0 * side));
            turned += wrap_angle(robot.rig.pose().yaw - before);
        }
        EXPECT_GT(side * turned, radians(110) * 4.6);
        EXPECT_LT(robot.rig.pose().position.norm(), 0.3);
        EXPECT_EQ(robot.motion.state().falls, 0);
    }
}

TEST(WalkContract, SlowWishesAreKeptToo) {
    Walker robot;
    robot.run(1.0, {});
    robot.run(5.0, walk(0.15, 0, 0));
    EXPECT_NEAR(robot.rig.pose().position.x(), 0.15 * 5.0, 0.2);
    EXPECT_EQ(robot.motion.state().falls, 0);
}

TEST(WalkContract, SurvivesAMinuteOfRandomWishes) {
    RandomStream random(11, "walk", "wishes");
    Walker robot;
    robot.run(1.0, {});
    double left = 60.0;
    while (left > 0.0) {
        const double seconds = random.uniform(1.0, 3.0);
        Request request =
            walk(random.uniform(-1.0, 1.0), random.uniform(-0.5, 0.5), random.uniform(-2.5, 2.5));
        if (random.below(5) == 0) request.body = Stand{};
        robot.run(seconds, request);
        left -= seconds;
    }
    EXPECT_EQ(robot.motion.state().falls, 0);
}

TEST(WalkContract, OdometryFollowsTheTruth) {
    Walker robot;
    robot.run(1.0, {});
    robot.run(5.0, walk(0.5, 0, 0.3));
    robot.run(3.0, walk(0, 0.2, 0));
    robot.run(3.0, walk(-0.3, 0, -0.5));
    robot.run(1.0, {});
    const Pose2 truth = robot.rig.pose();
    EXPECT_LT((robot.odometry.position - truth.position).norm(), 0.6);
    EXPECT_NEAR(wrap_angle(robot.odometry.yaw - truth.yaw), 0.0, radians(5));
}

TEST(WalkContract, PostureAndCameraAreTrueWhileWalking) {
    Walker robot;
    robot.run(1.0, {});
    for (int i = 0; i < 200; ++i) {
        // What motion says now is about the state before the step that follows.
        const Quat torso = robot.rig.robot().torso_rotation();
        const Vec3 head = robot.rig.robot().position(2);
        const Pose2 pose = robot.rig.pose();
        const State& state = robot.motion.step(robot.rig.sense(), walk(0.5, 0, 0.5), robot.rates);
        const Vec3 up = torso.conjugate() * Vec3::UnitZ();  // body axes
        const Vec3 believed = state.torso.conjugate() * Vec3::UnitZ();
        EXPECT_LT((Vec3(up.y(), -up.x(), up.z()) - believed).norm(), radians(2.5));
        const Vec2 level = pose.to_local({head.x(), head.y()});
        EXPECT_LT((state.camera - Vec3(level.x(), level.y(), head.z())).norm(), 0.03);
        robot.rig.advance(robot.rates);
    }
}

TEST(WalkContract, HeadLooksWhereItIsAsked) {
    Walker robot;
    for (const double yaw : {0.9, -1.5}) {
        Request request;
        request.head = {yaw, -0.4};
        robot.run(1.5, request);
        const Vec3 sight = robot.motion.state().camera_rotation * Vec3::UnitX();
        EXPECT_NEAR(std::atan2(sight.y(), sight.x()), yaw, radians(2));
        EXPECT_NEAR(std::asin(sight.z()), -0.4, radians(2));
    }
}

}  // namespace
}  // namespace k3d::contract
