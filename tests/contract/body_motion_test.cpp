// SPDX-License-Identifier: BSD-3-Clause
// The body's choice between standing, walking, kicking, falling and getting up.
#include "agent/motion/body_motion.h"

#include <gtest/gtest.h>

#include <set>

#include "contract/body_rig.h"

namespace k3d::contract {
namespace {

using agent::motion::Activity;
using agent::motion::BodyMotion;
using agent::motion::Config;
using agent::motion::Kick;
using agent::motion::Request;
using agent::motion::State;
using agent::motion::Walk;

class Falls : public testing::TestWithParam<double> {};

TEST_P(Falls, AreNoticedOnceAndGotUpFrom) {
    BodyRig rig;
    BodyMotion motion(rig.model(), Config{});
    nao::JointArray rates{};
    std::set<Activity> seen;
    for (int i = 0; i < 50 * 12; ++i) {
        const State& state = motion.step(rig.sense(), Request{}, rates);
        seen.insert(state.activity);
        if (i >= 50 && i < 70) {  // the ankles tip the robot over, whatever motion wants
            rates[nao::index(nao::JointId::RAnklePitch)] = GetParam();
            rates[nao::index(nao::JointId::LAnklePitch)] = GetParam();
        }
        rig.advance(rates);
    }
    EXPECT_TRUE(seen.contains(Activity::Falling));
    EXPECT_TRUE(seen.contains(Activity::GettingUp));
    EXPECT_EQ(motion.state().falls, 1);
    EXPECT_TRUE(motion.state().upright);
    EXPECT_EQ(motion.state().activity, Activity::Standing);
    EXPECT_LT(rig.tilt(), radians(12));
}

INSTANTIATE_TEST_SUITE_P(BackAndFront, Falls, testing::Values(-2.5, 2.5),
                         [](const auto& test) { return test.param < 0.0 ? "Back" : "Front"; });

TEST(BodyMotionContract, WalksOnAfterAFallInTheMiddleOfAWalk) {
    BodyRig rig;
    BodyMotion motion(rig.model(), Config{});
    nao::JointArray rates{};
    const Request request{.body = Walk{0.5, 0, 0.3}, .head = {}};
    for (int i = 0; i < 50 * 15; ++i) {
        motion.step(rig.sense(), request, rates);
        if (i >= 150 && i < 170) {
            rates[nao::index(nao::JointId::RHipPitch)] = 4.0;
            rates[nao::index(nao::JointId::LHipPitch)] = 4.0;
        }
        rig.advance(rates);
    }
    EXPECT_EQ(motion.state().falls, 1);
    EXPECT_EQ(motion.state().activity, Activity::Walking);
}

TEST(BodyMotionContract, KicksWhenAskedTellsStartAndEndAndWalksOn) {
    BodyRig rig;
    const Config config;
    BodyMotion motion(rig.model(), config);
    nao::JointArray rates{};
    const auto step = [&](const Request& request) {
        const State& state = motion.step(rig.sense(), request, rates);
        rig.advance(rates);
        return state;
    };
    for (int i = 0; i < 50; ++i) step({.body = Walk{0.3, 0, 0}, .head = {}});
    for (int i = 0; i < 50; ++i) step({});
    // Put the ball where the right foot reaches it.
    Kick kick;
    kick.ball = {config.kick.straight.ball_forward, -config.kick.straight.ball_outward};
    const Vec2 ball = rig.pose().to_global(kick.ball);
    rig.ball().move({ball.x(), ball.y(), 0.0403});
    int started = 0;
    int done = 0;
    int kicking = 0;
    for (int i = 0; i < 50 * 5 && done == 0; ++i) {
        const State state = step({.body = kick, .head = {}});
        started += state.kick_started;
        done += state.kick_done;
        kicking += state.activity == Activity::Kicking;
        EXPECT_LE(done, started);
    }
    EXPECT_EQ(started, 1);
    EXPECT_EQ(done, 1);
    EXPECT_GT(kicking, 10);
    const Pose2 before = rig.pose();
    for (int i = 0; i < 100; ++i) step({.body = Walk{-0.4, 0, 0}, .head = {}});
    EXPECT_GT((rig.pose().position - before.position).norm(), 0.3);
    EXPECT_GT((rig.ball().position().head<2>() - ball).norm(), 2.5);
    EXPECT_EQ(motion.state().falls, 0);
}

TEST(BodyMotionContract, AKickAskedForInTheWalkWaitsForQuietStanding) {
    BodyRig rig;
    const Config config;
    BodyMotion motion(rig.model(), config);
    nao::JointArray rates{};
    Kick kick;
    kick.ball = {config.kick.straight.ball_forward, -config.kick.straight.ball_outward};
    double last_walked = 0.0;
    double kicked = 0.0;
    for (int i = 0; i < 50 * 6 && kicked == 0.0; ++i) {
        Request request;
        if (i < 100) request.body = Walk{0.3, 0, 0};
        if (i >= 100) request.body = kick;
        const State& state = motion.step(rig.sense(), request, rates);
        if (state.activity == Activity::Walking) last_walked = rig.time();
        if (state.kick_started) kicked = rig.time();
        rig.advance(rates);
    }
    EXPECT_GT(last_walked, 2.0);
    EXPECT_GE(kicked, last_walked + config.kick_settle_s - 1e-9);
}

TEST(BodyMotionContract, AKickOutOfReachIsNotBegun) {
    BodyRig rig;
    BodyMotion motion(rig.model(), Config{});
    nao::JointArray rates{};
    Kick kick;
    kick.ball = {2.0, 0.0};
    for (int i = 0; i < 100; ++i) {
        const State& state = motion.step(rig.sense(), {.body = kick, .head = {}}, rates);
        EXPECT_NE(state.activity, Activity::Kicking);
        rig.advance(rates);
    }
    EXPECT_EQ(motion.state().falls, 0);
}

}  // namespace
}  // namespace k3d::contract
