// SPDX-License-Identifier: BSD-3-Clause
// The kick in the server's physics: how far, how straight, without falling, with either foot.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "agent/motion/kick/kick_engine.h"
#include "common/random/stream.h"
#include "contract/engine_rig.h"

namespace k3d::contract {
namespace {

using agent::kick::Config;
using agent::kick::Foot;
using agent::kick::KickEngine;
using agent::kick::kick_possible;
using agent::kick::kStrikes;
using agent::kick::possible_strike;
using agent::kick::stand_pose;
using agent::kick::Strike;
using agent::kick::suits;
using agent::kick::Way;
using agent::motion::Kick;

struct Outcome {
    double distance = 0.0;   ///< m from where the ball lay
    double off_deg = 0.0;    ///< direction against the one wanted
    double duration = 0.0;   ///< s of the motion
    bool fell = false;
};

/// Kicks a ball that lies `ball_off` from where this strike wants it. The engine is told the perfect
/// place; the direction wanted is `turned` off the one kicked to.
Outcome kick_once(const Strike& strike, double distance, const Vec2& ball_off, double turned) {
    const Config config;
    const Pose2 stand = stand_pose(config, Vec2::Zero(), 0.0, strike);
    const Vec2 place = stand.to_local(Vec2::Zero());
    EngineRig r;
    r.take(walk_stance(), 0.5, 0.4);
    const Pose2 self = r.rig.pose();
    const Vec2 ball = self.to_global(place + ball_off);
    r.rig.ball().move({ball.x(), ball.y(), 0.0403});
    KickEngine engine{config};
    engine.start({place, -stand.yaw, distance}, walk_stance());
    Outcome o;
    o.duration = r.run(engine, 3.0);
    r.take(walk_stance(), 0.0, 4.0);
    const Vec3 end = r.rig.ball().position();
    const Vec2 way = Vec2(end.x(), end.y()) - ball;
    o.distance = way.norm();
    o.off_deg = degrees(std::abs(wrap_angle(yaw_of(way) - (self.yaw - stand.yaw + turned))));
    o.fell = r.rig.tilt() > radians(20.0);
    return o;
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

class EitherFoot : public testing::TestWithParam<Foot> {};

TEST_P(EitherFoot, SendsAMisplacedBallFarAndStraightWithoutAFall) {
    RandomStream random(2, "kick_test", "placement");
    std::vector<double> off;
    constexpr int kKicks = 40;
    int good = 0;
    for (int n = 0; n < kKicks; ++n) {
        const Vec2 ball_off(random.uniform(-0.015, 0.015), random.uniform(-0.015, 0.015));
        const double turned = radians(random.uniform(-3.0, 3.0));
        const Outcome o = kick_once({Way::Straight, GetParam()}, 6.0, ball_off, turned);
        if (!o.fell && o.distance >= 3.0) ++good;
        off.push_back(o.off_deg);
        EXPECT_LT(o.duration, 1.5);
    }
    EXPECT_GE(good, 38) << "of " << kKicks;
    EXPECT_LE(median(off), 7.0);
}

TEST_P(EitherFoot, KicksShorterWhenAskedTo) {
    const Outcome near = kick_once({Way::Straight, GetParam()}, 3.0, Vec2::Zero(), 0.0);
    const Outcome far = kick_once({Way::Straight, GetParam()}, 6.0, Vec2::Zero(), 0.0);
    EXPECT_FALSE(near.fell);
    EXPECT_FALSE(far.fell);
    EXPECT_NEAR(near.distance, Config{}.near.reach_m, 0.7);
    EXPECT_NEAR(far.distance, Config{}.far.reach_m, 0.7);
}

TEST_P(EitherFoot, SendsABallFartherThanTheOtherSwingsReach) {
    RandomStream random(4, "kick_test", "farthest");
    const Config config;
    std::vector<double> distance;
    for (int n = 0; n < 20; ++n) {
        const Vec2 ball_off(random.uniform(-0.008, 0.008), random.uniform(-0.015, 0.015));
        const Outcome o = kick_once({Way::Farthest, GetParam()}, 9.0, ball_off, 0.0);
        EXPECT_FALSE(o.fell) << n;
        EXPECT_LT(o.duration, 1.5);
        distance.push_back(o.distance);
    }
    EXPECT_GE(median(distance), 6.0);
}

TEST_P(EitherFoot, SendsAMisplacedBallAsideWithoutAFall) {
    RandomStream random(3, "kick_test", "aside");
    const Config config;
    for (const Way way : {Way::Slant, Way::Square}) {
        const double reach = (way == Way::Slant ? config.slant : config.square).swing.reach_m;
        std::vector<double> off;
        constexpr int kKicks = 20;
        int good = 0;
        for (int n = 0; n < kKicks; ++n) {
            const Vec2 ball_off(random.uniform(-0.015, 0.015), random.uniform(-0.015, 0.015));
            const Outcome o = kick_once({way, GetParam()}, reach, ball_off, 0.0);
            if (!o.fell && std::abs(o.distance - reach) < 1.0) ++good;
            off.push_back(o.off_deg);
            EXPECT_LT(o.duration, 1.2);
        }
        EXPECT_GE(good, 19) << "of " << kKicks;
        EXPECT_LE(median(off), 5.0);
    }
}

INSTANTIATE_TEST_SUITE_P(Feet, EitherFoot, testing::Values(Foot::Right, Foot::Left),
                         [](const auto& test) { return test.param == Foot::Left ? "Left" : "Right"; });

TEST(KickReach, TheStandPosePutsTheBallInReachOfThatStrike) {
    const Config config;
    const Vec2 ball(1.0, -2.0);
    for (const Strike& strike : kStrikes) {
        for (const double direction : {-3.0, -1.0, 0.0, 0.5, 2.9}) {
            const Pose2 pose = stand_pose(config, ball, direction, strike);
            const double wanted = strike.way == Way::Farthest ? config.farthest.from_m + 1.0 : 4.8;
            const Kick kick{pose.to_local(ball), wrap_angle(direction - pose.yaw), wanted};
            EXPECT_EQ(possible_strike(config, kick), strike) << direction;
        }
    }
}

TEST(KickReach, TheLeftFootMirrorsTheRight) {
    const Config config;
    for (const Way way : {Way::Straight, Way::Slant, Way::Square, Way::Farthest}) {
        const Pose2 right = stand_pose(config, Vec2::Zero(), 0.0, {way, Foot::Right});
        const Pose2 left = stand_pose(config, Vec2::Zero(), 0.0, {way, Foot::Left});
        EXPECT_NEAR(left.yaw, -right.yaw, 1e-12);
        EXPECT_NEAR(left.position.x(), right.position.x(), 1e-12);
        EXPECT_NEAR(left.position.y(), -right.position.y(), 1e-12);
    }
    const Pose2 slant = stand_pose(config, Vec2::Zero(), 0.0, {Way::Slant, Foot::Right});
    EXPECT_NEAR(slant.yaw, radians(config.slant.place.aim_outward_deg), 1e-12)
        << "the right foot sends the ball to its right";
}

TEST(KickReach, ABallFarOffOrAnotherDirectionIsOutOfReach) {
    const Config config;
    const Vec2 place(config.straight.ball_forward, config.straight.ball_outward);
    EXPECT_TRUE(kick_possible(config, {place, radians(config.straight.aim_outward_deg), 4.0}));
    EXPECT_FALSE(kick_possible(config, {place + Vec2(0.1, 0.0), 0.0, 4.0}));
    EXPECT_FALSE(kick_possible(config, {place + Vec2(0.0, 0.1), 0.0, 4.0}));
    EXPECT_FALSE(kick_possible(config, {place, 1.0, 4.0}));
    EXPECT_FALSE(kick_possible(config, {-place, 0.0, 4.0}));
}

TEST(KickReach, ASwingToTheSideKnowsOneDistanceAndCanBeSwitchedOff) {
    Config config;
    const Strike slant{Way::Slant, Foot::Right};
    const double reach = config.slant.swing.reach_m;
    EXPECT_TRUE(suits(config, slant, reach + 0.9 * config.angled_miss_m));
    EXPECT_FALSE(suits(config, slant, reach + 1.1 * config.angled_miss_m));
    const Pose2 pose = stand_pose(config, Vec2::Zero(), 0.0, slant);
    const Kick kick{pose.to_local(Vec2::Zero()), -pose.yaw, reach};
    EXPECT_TRUE(kick_possible(config, kick));
    config.slant.on = false;
    EXPECT_FALSE(kick_possible(config, kick));
    EXPECT_FALSE(suits(config, slant, reach));
}

TEST(KickReach, TheLongestSwingIsForWhatTheOthersDoNotReach) {
    Config config;
    const Strike farthest{Way::Farthest, Foot::Left};
    const Strike straight{Way::Straight, Foot::Left};
    const double from = config.farthest.from_m;
    EXPECT_FALSE(suits(config, farthest, from));
    EXPECT_TRUE(suits(config, straight, from));
    EXPECT_TRUE(suits(config, farthest, from + 0.1));
    EXPECT_FALSE(suits(config, straight, from + 0.1));
    EXPECT_LT(stance_share(config, farthest), stance_share(config, straight));
    config.farthest.on = false;
    EXPECT_FALSE(suits(config, farthest, from + 0.1));
    EXPECT_TRUE(suits(config, straight, from + 0.1));
}

}  // namespace
}  // namespace k3d::contract
