// SPDX-License-Identifier: BSD-3-Clause
// Tests of meeting a rolling ball for a kick, with a ball that rolls as the field says and a robot
// that stands or cannot be there in time.
#include "agent/skills/kick_meeting.h"

#include <gtest/gtest.h>

#include <cmath>

#include "agent/decision/keepaway/scene.h"
#include "common/field/field.h"

namespace k3d::agent::skills {
namespace {

const SkillConfig kConfig;
const KickGeometry kKick = decision::test::simple_kick();
const Vec2 kTarget(5.0, 0.0);

/// A ball on its way to the origin along +y that still has `way` metres to go.
world::Ball rolling(double way) {
    world::Ball ball;
    ball.known = true;
    ball.position = {0.0, -way};
    ball.velocity = {0.0, field::kRollDecay * way};
    ball.moving = true;
    return ball;
}

/// Where it is `time` later.
Vec2 later(const world::Ball& ball, double time) {
    return ball.finish + std::exp(-field::kRollDecay * time) * (ball.position - ball.finish);
}

Pose2 stance_for(const Vec2& ball) {
    return kKick.stand_pose(0, ball, yaw_of(kTarget - ball));
}

TEST(KickMeeting, ABallAtRestIsKickedWhereItLies) {
    world::Ball ball;
    ball.position = ball.finish = {1.0, 2.0};
    const Meeting m = KickMeeting().plan({}, ball, kTarget, true, true, kKick, kConfig);
    EXPECT_TRUE(m.arrived);
    EXPECT_FALSE(m.rolling);
    EXPECT_EQ(m.point, ball.position);
    EXPECT_EQ(m.ball_at_hit, ball.position);
}

TEST(KickMeeting, WhoMayNotKickPreparesForTheStoppingPoint) {
    const world::Ball ball = rolling(1.0);
    const Meeting m =
        KickMeeting().plan(stance_for({0.0, -0.25}), ball, kTarget, false, true, kKick, kConfig);
    EXPECT_EQ(m.point, ball.finish);
    EXPECT_FALSE(m.rolling);
}

TEST(KickMeeting, WhoStandsReadySwingsSoThatTheFootMeetsTheRollingBall) {
    const Pose2 self = stance_for({0.0, -kConfig.meet_before_finish});
    KickMeeting meeting;
    world::Ball ball = rolling(1.5);
    for (double time = 0.0; time < 5.0; time += 0.02) {
        const Meeting m = meeting.plan(self, ball, kTarget, true, true, kKick, kConfig);
        EXPECT_TRUE(m.rolling);
        if (m.arrived) {
            const Vec2 hit = later(ball, kConfig.kick_lead);
            EXPECT_LT((hit - m.point).norm(), 0.03) << "the ball is not where it is hit";
            EXPECT_LT((m.ball_at_hit - hit).norm(), 1e-3);
            EXPECT_GT(ball.position.norm(), 0.2) << "long before it lies";
            return;
        }
        ball.position = later(ball, 0.02);
        ball.velocity = field::kRollDecay * (ball.finish - ball.position);
    }
    FAIL() << "it never swings";
}

TEST(KickMeeting, WhoStandsALittleOffLetsTheBallCome) {
    // A centimetre off along the ball's way: the ball is hit there, and nobody steps.
    const double before = kConfig.meet_before_finish - 0.01;
    const Meeting m = KickMeeting().plan(stance_for({0.0, -before}), rolling(2.0), kTarget, true,
                                         true, kKick, kConfig);
    EXPECT_NEAR(m.point.y(), -before, 2e-3);
}

TEST(KickMeeting, WhoComesTooLateGoesToTheStoppingPoint) {
    const Meeting far =
        KickMeeting().plan({{-3.0, 0.0}, 0.0}, rolling(0.5), kTarget, true, false, kKick, kConfig);
    EXPECT_LT((far.point - Vec2::Zero()).norm(), 0.021);
    const Meeting near = KickMeeting().plan({{-0.3, -0.25}, 0.0}, rolling(2.5), kTarget, true,
                                            false, kKick, kConfig);
    EXPECT_NEAR(near.point.y(), -kConfig.meet_before_finish, 1e-9);
    EXPECT_FALSE(near.arrived);
}

TEST(KickMeeting, AnotherRollIsMetAnew) {
    KickMeeting meeting;
    const Pose2 self{{-3.0, 0.0}, 0.0};
    meeting.plan(self, rolling(0.5), kTarget, true, false, kKick, kConfig);
    world::Ball other = rolling(3.0);
    other.position += Vec2(-3.0, 0.0);
    other.finish += Vec2(-3.0, 0.0);
    const Meeting m = meeting.plan(self, other, kTarget, true, false, kKick, kConfig);
    EXPECT_NEAR((m.point - other.finish).norm(), kConfig.meet_before_finish, 1e-9);
}

}  // namespace
}  // namespace k3d::agent::skills
