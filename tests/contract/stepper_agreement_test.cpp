// SPDX-License-Identifier: BSD-3-Clause
// What comes out of the fast stepper in the long run, against the exact one: stance, forces, ball,
// joints, walk, kick, falls, getting up. The tolerances are what users may rely on.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "agent/motion/body_motion.h"
#include "common/random/stream.h"
#include "contract/body_rig.h"
#include "server/body/scene.h"

namespace k3d::contract {
namespace {

using agent::motion::Activity;
using agent::motion::BodyMotion;
using agent::motion::Config;
using agent::motion::Kick;
using agent::motion::Request;
using agent::motion::Stand;
using agent::motion::Walk;
using server::body::Scene;
using server::physics::Stepper;

constexpr std::array kBoth{Stepper::Exact, Stepper::Fast};

class EveryTypeAgrees : public testing::TestWithParam<int> {};

TEST_P(EveryTypeAgrees, TwistOfTheFirstCycleToFourDigits) {
    std::array<Vec3, 2> linear, angular;
    for (std::size_t s = 0; s < 2; ++s) {
        Scene scene(kBoth[s]);
        server::body::Robot& robot =
            *scene.add_player(GetParam(), {0, 0, nao::model(GetParam()).standing_height}).robot;
        double rate = 1.0;
        for (const nao::JointDef& joint : robot.model().joints) {
            robot.drive(joint.id, rate);
            rate = -1.1 * rate;
        }
        scene.world.step();
        linear[s] = robot.torso_velocity();
        angular[s] = robot.torso_angular_velocity();
    }
    EXPECT_GT(linear[0].norm() + angular[0].norm(), 0.1) << "it must move";
    EXPECT_LT((linear[1] - linear[0]).norm(), 1e-4 * linear[0].norm());
    EXPECT_LT((angular[1] - angular[0]).norm(), 1e-4 * angular[0].norm());
}

TEST_P(EveryTypeAgrees, StanceToAMillimetreAndFootForcesToATenthOfANewton) {
    std::array<double, 2> height{};
    std::array<double, 2> weight{};
    for (std::size_t s = 0; s < 2; ++s) {
        Scene scene(kBoth[s]);
        server::body::Robot& robot = *scene.add_player(GetParam(), {0, 0, 0.46}).robot;
        for (int i = 0; i < 150; ++i) {
            // Keeps ODE from putting the robot to sleep, in which it reports no forces.
            robot.drive(nao::JointId::HeadYaw, i % 2 == 0 ? 0.01 : -0.01);
            scene.world.step();
        }
        height[s] = robot.torso_position().z();
        for (const server::physics::Contact& contact : scene.world.contacts()) {
            if (contact.a->kind == server::physics::Kind::Robot) weight[s] += contact.force_on_a.z();
        }
    }
    EXPECT_NEAR(height[1], height[0], 1e-3);
    EXPECT_NEAR(weight[1], weight[0], 0.1);
    EXPECT_NEAR(weight[1], 9.81 * nao::model(GetParam()).total_mass, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Types, EveryTypeAgrees, testing::Range(0, nao::kTypeCount));

TEST(SteppersAgree, OnTheBallsRollAndBounceToAMillimetre) {
    for (const double speed : {1.0, 3.0, 6.0}) {
        Scene exact(Stepper::Exact);
        Scene fast(Stepper::Fast);
        for (Scene* scene : {&exact, &fast}) {
            scene->ball.move({0, 0, 1.042});
            scene->ball.set_velocity({speed, 0, 0});
        }
        double apart = 0.0;
        for (int i = 0; i < 250; ++i) {
            exact.world.step();
            fast.world.step();
            apart = std::max(apart, (exact.ball.position() - fast.ball.position()).norm());
        }
        EXPECT_LT(apart, 1e-3) << "thrown with " << speed << " m/s";
        EXPECT_GT(exact.ball.position().x(), 0.5 * speed);
    }
}

TEST(SteppersAgree, OnAJointsResponseAndItsStopsToATenthOfADegree) {
    Scene exact(Stepper::Exact);
    Scene fast(Stepper::Fast);
    for (Scene* scene : {&exact, &fast}) scene->add_player(0, {0, 0, 0.385});
    double widest = 0.0;
    for (int i = 0; i < 120; ++i) {
        std::array<double, 2> angle{};
        for (std::size_t s = 0; s < 2; ++s) {
            Scene& scene = s == 0 ? exact : fast;
            server::body::Robot& robot = *scene.players[0]->robot;
            const double rate = i < 40 ? 2.0 : i < 80 ? 7.0 : -3.0;
            for (const auto id : {nao::JointId::HeadPitch, nao::JointId::LElbow,
                                  nao::JointId::RShoulderPitch}) {
                robot.drive(id, rate);
            }
            scene.world.step();
            angle[s] = robot.angle(nao::JointId::LElbow);
            widest = std::max(widest, angle[s]);
        }
        EXPECT_NEAR(degrees(angle[1]), degrees(angle[0]), 0.1) << "cycle " << i;
    }
    EXPECT_GT(widest, radians(1.0)) << "the upper stop must be overshot";
}

struct Way {
    double length = 0.0;  ///< m from start to end
    double turned = 0.0;  ///< rad
};

Way walked(Stepper stepper, const Walk& walk, double seconds) {
    BodyRig rig(0, {}, stepper);
    BodyMotion motion(rig.model(), Config{});
    nao::JointArray rates{};
    Way way;
    Pose2 start;
    for (int i = 0; i < static_cast<int>(seconds * 50.0) + 50; ++i) {
        Request request;
        if (i >= 50) request.body = walk;
        if (i == 50) start = rig.pose();
        motion.step(rig.sense(), request, rates);
        const double before = rig.pose().yaw;
        rig.advance(rates);
        way.turned += wrap_angle(rig.pose().yaw - before);
    }
    way.length = (rig.pose().position - start.position).norm();
    return way;
}

TEST(SteppersAgree, OnWalkSpeedAndTurnRateToFivePercent) {
    for (const Walk& walk : {Walk{2.0, 0, 0}, Walk{-2.0, 0, 0}, Walk{0, 2.0, 0}}) {
        const Way exact = walked(Stepper::Exact, walk, 5.0);
        const Way fast = walked(Stepper::Fast, walk, 5.0);
        EXPECT_GT(exact.length, 1.0);
        EXPECT_NEAR(fast.length, exact.length, 0.05 * exact.length);
    }
    const Way exact = walked(Stepper::Exact, Walk{0, 0, 4.0}, 5.0);
    const Way fast = walked(Stepper::Fast, Walk{0, 0, 4.0}, 5.0);
    EXPECT_GT(exact.turned, 4.0);
    EXPECT_NEAR(fast.turned, exact.turned, 0.05 * exact.turned);
}

/// How far a kick sends a ball that lies `off` from the best place.
double kicked(Stepper stepper, const Vec2& off) {
    BodyRig rig(0, {}, stepper);
    const Config config;
    BodyMotion motion(rig.model(), config);
    nao::JointArray rates{};
    Kick kick;
    kick.ball = {config.kick.straight.ball_forward, -config.kick.straight.ball_outward};
    Vec2 ball = Vec2::Zero();
    for (int i = 0; i < 50 * 6; ++i) {
        if (i == 60) {
            ball = rig.pose().to_global(kick.ball + off);
            rig.ball().move({ball.x(), ball.y(), 0.0403});
        }
        Request request;
        if (i > 60 && i < 200) request.body = kick;
        motion.step(rig.sense(), request, rates);
        rig.advance(rates);
    }
    return (rig.ball().position().head<2>() - ball).norm();
}

TEST(SteppersAgree, OnTheMeanLengthOfKicksToTenPercent) {
    RandomStream random(3, "stepper_agreement_test", "ball");
    constexpr int kKicks = 12;
    std::array<double, 2> mean{};
    for (int n = 0; n < kKicks; ++n) {
        const Vec2 off(random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01));
        for (std::size_t s = 0; s < 2; ++s) mean[s] += kicked(kBoth[s], off) / kKicks;
    }
    EXPECT_GT(mean[0], 2.0);
    EXPECT_NEAR(mean[1], mean[0], 0.1 * mean[0]);
}

struct Tumbles {
    int falls = 0;
    int got_up = 0;  ///< stood again at the end of the 8 s from being tipped over
};

/// Robots walk anywhere and are tipped over by their ankles.
Tumbles tumble(Stepper stepper, int robots) {
    RandomStream random(4, "stepper_agreement_test", "falls");
    Tumbles result;
    for (int n = 0; n < robots; ++n) {
        BodyRig rig(0, {}, stepper);
        BodyMotion motion(rig.model(), Config{});
        nao::JointArray rates{};
        const Walk walk{random.uniform(-0.5, 0.8), random.uniform(-0.3, 0.3),
                        random.uniform(-1.5, 1.5)};
        const double right = random.uniform(-3.0, 3.0);
        const double left = random.uniform(-3.0, 3.0);
        for (int i = 0; i < 50 * 9; ++i) {
            Request request;
            if (i < 50) request.body = walk;
            motion.step(rig.sense(), request, rates);
            if (i >= 50 && i < 75) {
                rates[nao::index(nao::JointId::RAnklePitch)] = right;
                rates[nao::index(nao::JointId::LAnklePitch)] = left;
            }
            rig.advance(rates);
        }
        result.falls += motion.state().falls;
        result.got_up += motion.state().falls > 0 &&
                         motion.state().activity == Activity::Standing && rig.tilt() < radians(15);
    }
    return result;
}

TEST(SteppersAgree, OnFallsAndOnGettingUp) {
    constexpr int kRobots = 16;
    const Tumbles exact = tumble(Stepper::Exact, kRobots);
    const Tumbles fast = tumble(Stepper::Fast, kRobots);
    EXPECT_GT(exact.falls, kRobots / 3) << "the test must make robots fall";
    EXPECT_NEAR(fast.falls, exact.falls, 2);
    EXPECT_NEAR(fast.got_up, exact.got_up, 2);
}

}  // namespace
}  // namespace k3d::contract
