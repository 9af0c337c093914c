// SPDX-License-Identifier: BSD-3-Clause
// Tests of positioning for a kick, with a perfect walk: it gets there from everywhere without
// touching the ball, and kicks only when placed and allowed.
#include "agent/skills/kick_position.h"

#include <gtest/gtest.h>

#include "agent/decision/keepaway/scene.h"

namespace k3d::agent::skills {
namespace {

const SkillConfig kConfig;
const KickGeometry kKick = decision::test::simple_kick();

TEST(KickPosition, ReachesTheStanceFromEverywhereWithoutTouchingTheBall) {
    const Vec2 ball(0.0, 0.0);
    for (int start = 0; start < 12; ++start)
        for (const double yaw : {0.0, 2.0, -2.0}) {
            Pose2 self{direction(start * kPi / 6.0) * 0.9, yaw};
            bool kicked = false;
            for (int i = 0; i < 1000 && !kicked; ++i) {
    const KickSituation s{self, ball, ball, {5.0, 0.0}, 0.0, true, false, false};
                const motion::BodyRequest r = position_for_kick(s, kKick, {}, kConfig);
                kicked = decision::test::is_kick(r);
                if (const auto* w = std::get_if<motion::Walk>(&r))
                    self = self.then({Vec2(w->forward, w->left) * 0.02, w->turn * 0.02});
                ASSERT_GT((self.position - ball).norm(), 0.17) << start << " " << yaw;
            }
            EXPECT_TRUE(kicked) << start << " " << yaw;
            EXPECT_NEAR(self.yaw, 0.0, kConfig.kick_tolerance_yaw);
        }
}

TEST(KickPosition, StandsReadyWhenItMayNotKick) {
    const KickSituation s{{{-0.2, 0.0}, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {5.0, 0.0}, 0.0, false, true, false};
    EXPECT_TRUE(decision::test::is_stand(position_for_kick(s, kKick, {}, kConfig)));
}

TEST(KickPosition, PressureLoosensTheTolerances) {
    KickSituation s{{{-0.2, 1.2 * kConfig.kick_tolerance_y}, 1.5 * kConfig.kick_tolerance_yaw}, {0.0, 0.0}, {0.0, 0.0}, {5.0, 0.0}, 0.0, true, false, false};
    EXPECT_TRUE(decision::test::is_walk(position_for_kick(s, kKick, {}, kConfig)));
    s.pressure = 1.0;
    EXPECT_TRUE(decision::test::is_kick(position_for_kick(s, kKick, {}, kConfig)));
}

TEST(KickPosition, AKickThatMustBePlacedExactlyGetsAShareOfTheTolerance) {
    KickGeometry exact = kKick;
    exact.stance_share = [](int) { return 0.5; };
    const KickSituation s{{{-0.2 + 0.7 * kConfig.kick_tolerance_x, 0.0}, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {5.0, 0.0}, 0.0, true, false, false};
    EXPECT_TRUE(decision::test::is_kick(position_for_kick(s, kKick, {}, kConfig)));
    EXPECT_TRUE(decision::test::is_walk(position_for_kick(s, exact, {}, kConfig)));
}

TEST(KickPosition, KicksOnlyWhatTheEngineCanReach) {
    KickGeometry unable = kKick;
    unable.possible = [](const motion::Kick&) { return false; };
    const KickSituation s{{{-0.2, 0.0}, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {5.0, 0.0}, 0.0, true, false, false};
    EXPECT_FALSE(decision::test::is_kick(position_for_kick(s, unable, {}, kConfig)));
}

TEST(KickPosition, WaitsInTheStanceForARollingBall) {
    KickSituation s{{{-0.2, 0.0}, 0.0}, {0.0, 0.0}, {-0.1, 0.15}, {5.0, 0.0}, 0.0, true, false, false};
    EXPECT_FALSE(decision::test::is_kick(position_for_kick(s, kKick, {}, kConfig)));
    s.ball_now = {0.01, 0.0};
    EXPECT_TRUE(decision::test::is_kick(position_for_kick(s, kKick, {}, kConfig)));
}

TEST(StanceError, InTheStancesFrameAndScaled) {
    const StanceError e = stance_error({{0.0, 0.1}, kPi / 2.0}, {{0.0, 0.0}, kPi / 2.0}, 0.0, kConfig);
    EXPECT_NEAR(e.x, 0.1, 1e-12);
    EXPECT_NEAR(e.y, 0.0, 1e-12);
    EXPECT_NEAR(e.worst, 0.1 / kConfig.kick_tolerance_x, 1e-9);
}

}  // namespace
}  // namespace k3d::agent::skills
