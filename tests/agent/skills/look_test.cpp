// SPDX-License-Identifier: BSD-3-Clause
// Tests of looking: the ball in the picture, the sweep, the search.
#include "agent/skills/look.h"

#include <gtest/gtest.h>

#include "agent/decision/keepaway/scene.h"

namespace k3d::agent::skills {
namespace {

const SkillConfig kConfig;

motion::State standing() {
    motion::State s;
    s.camera = {0.0, 0.0, 0.5};
    return s;
}

TEST(Look, AtAPointOnTheGround) {
    const motion::HeadRequest h = look_at({1.0, 1.0}, 0.5);
    EXPECT_NEAR(h.yaw, kPi / 4.0, 1e-9);
    EXPECT_NEAR(h.pitch, -std::atan2(0.458, std::sqrt(2.0)), 1e-9);
    EXPECT_GT(look_at({0.05, 0.0}, 0.5).pitch, -0.8);  // the neck ends at -45 degrees
    EXPECT_LT(look_at({-1.0, 0.1}, 0.5).yaw, 2.0);
}

TEST(Look, SweepsButKeepsTheBallInView) {
    double low = 9.0;
    double high = -9.0;
    for (double now = 10.0; now < 13.0; now += 0.02) {
        const world::Beliefs b = decision::test::scene(1, {{0.0, 0.0}, 0.5}, {2.0, 0.0}, now);
        const double yaw = look(b, standing(), false, kConfig).yaw;
        EXPECT_LT(std::abs(yaw + 0.5), radians(55.0));
        low = std::min(low, yaw);
        high = std::max(high, yaw);
    }
    EXPECT_NEAR(high - low, 2.0 * kConfig.look_sweep, 0.02);
}

TEST(Look, SearchesWhenTheBallIsLost) {
    double low = 9.0;
    double high = -9.0;
    for (double now = 10.0; now < 16.0; now += 0.02) {
        world::Beliefs b = decision::test::scene(1, {}, {2.0, 0.0}, now);
        b.ball.seen = now - 1.0;
        const double yaw = look(b, standing(), true, kConfig).yaw;
        low = std::min(low, yaw);
        high = std::max(high, yaw);
    }
    EXPECT_LT(low, radians(-90.0));
    EXPECT_GT(high, radians(90.0));
}

TEST(Look, TheBodyTurnsWhenTheHeadDoesNotFindIt) {
    world::Beliefs b = decision::test::scene(1, {}, {0.0, -2.0});
    EXPECT_FALSE(search_turn(b, kConfig));
    b.ball.seen = b.now - kConfig.look_turn_after - 0.1;
    ASSERT_TRUE(search_turn(b, kConfig));
    EXPECT_LT(search_turn(b, kConfig)->turn, 0.0);  // team-mates say it is on the right
    b.ball.known = false;
    EXPECT_GT(search_turn(b, kConfig)->turn, 0.0);
    EXPECT_EQ(search_turn(b, kConfig)->forward, 0.0);
}

}  // namespace
}  // namespace k3d::agent::skills
