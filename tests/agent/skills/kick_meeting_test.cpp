// SPDX-License-Identifier: BSD-3-Clause
// Tests of kicking a rolling ball: where, when, and for whom it is not possible.
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

/// Rolls along y to the origin.
world::Ball rolling(double to_go) {
    world::Ball ball;
    ball.known = ball.moving = to_go > 0.0;
    ball.position = {0.0, to_go};
    ball.velocity = {0.0, -to_go * field::kRollDecay};
    return ball;
}

/// Stands as a kick of a ball at `point` towards the target wants.
Pose2 behind(const Vec2& point) {
    return kKick.stand_pose({point, 0.0}, point, yaw_of(kTarget - point));
}

TEST(KickMeeting, SomewhatBeforeItComesToRest) {
    KickMeeting meeting;
    const Meeting m =
        meeting.plan({{-0.6, 0.1}, 0.0}, rolling(4.0), kTarget, true, false, kKick, kConfig);
    EXPECT_NEAR(m.point.x(), 0.0, 1e-9);
    EXPECT_NEAR(m.point.y(), kConfig.meet_before_finish, 1e-9);
    EXPECT_TRUE(m.rolling);
    EXPECT_FALSE(m.arrived);
}

TEST(KickMeeting, WhereItLiesForWhoMayNotKickOrComesTooLate) {
    KickMeeting meeting;
    const Pose2 near{{-0.6, 0.1}, 0.0};
    EXPECT_EQ(meeting.plan(near, rolling(4.0), kTarget, false, false, kKick, kConfig).point,
              Vec2(0.0, 0.0));
    const Pose2 far{{-3.0, 0.0}, 0.0};
    const Meeting late = meeting.plan(far, rolling(0.6), kTarget, true, false, kKick, kConfig);
    EXPECT_NEAR(late.point.norm(), 0.0, 0.021);
    meeting.reset();
    const Meeting lies = meeting.plan(near, rolling(0.0), kTarget, true, false, kKick, kConfig);
    EXPECT_EQ(lies.point, Vec2(0.0, 0.0));
    EXPECT_TRUE(lies.arrived);
    EXPECT_FALSE(lies.rolling);
}

TEST(KickMeeting, TheSwingBeginsSoThatItHits) {
    KickMeeting meeting;
    const Pose2 self = behind({0.0, kConfig.meet_before_finish});
    double time = 0.0;
    for (; time < 5.0; time += 0.02) {
        const world::Ball ball = rolling(3.0 * std::exp(-field::kRollDecay * time));
        const Meeting m = meeting.plan(self, ball, kTarget, true, true, kKick, kConfig);
        if (m.arrived) {
            EXPECT_NEAR((m.ball_at_hit - m.point).norm(), 0.0, 0.02);
            break;
        }
    }
    const double at_hit = 3.0 * std::exp(-field::kRollDecay * (time + kConfig.kick_lead));
    EXPECT_NEAR(at_hit, kConfig.meet_before_finish, 0.02);
}

TEST(KickMeeting, WhoStandsWellLetsTheBallCome) {
    KickMeeting meeting;
    // A centimetre off along the ball's way: the ball is hit there, and nobody steps.
    const Pose2 self = behind({0.0, kConfig.meet_before_finish - 0.01});
    const Meeting m = meeting.plan(self, rolling(2.0), kTarget, true, true, kKick, kConfig);
    EXPECT_NEAR(m.point.y(), kConfig.meet_before_finish - 0.01, 2e-3);
}

}  // namespace
}  // namespace k3d::agent::skills
