// SPDX-License-Identifier: BSD-3-Clause
// Localisation on a frame that the reference server (rcssserver3d 0.7.3) sent to a type 0 robot,
// which stood with all joints at zero where a noisy beam had put it: torso at (-3.018, 0.967), yaw
// 12.4 degrees by the monitor, camera 0.539 m high; ball in the centre, an opponent at (4.0, 0.0).
#include <gtest/gtest.h>

#include <string>

#include "agent/world/world_model.h"

namespace k3d::agent::world {
namespace {

constexpr const char* kFrame =
    "(time (now 2875.54))(GS (sl 0) (sr 0) (t 0.00) (pm BeforeKickOff))(GYR (n torso) (rt "
    "0.00 0.00 0.00))(ACC (n torso) (a 0.00 0.00 9.81))(HJ (n hj1) (ax 0.00))(HJ (n hj2) "
    "(ax -0.00))(See (G2R (pol 18.12 -18.95 0.81)) (G1R (pol 18.00 -12.04 0.91)) (F1R (pol "
    "20.19 14.40 -1.63)) (F2R (pol 21.09 -43.73 -1.50)) (B (pol 3.20 -30.02 -8.92)) (P "
    "(team Alpha) (id 1) (rlowerarm (pol 0.18 -34.06 -22.03)) (llowerarm (pol 0.19 35.76 "
    "-21.58))) (P (team Beta) (id 7) (head (pol 7.10 -20.24 0.03)) (rlowerarm (pol 6.94 "
    "-19.39 -0.51)) (llowerarm (pol 6.98 -21.22 -0.46)) (rfoot (pol 7.10 -19.84 -4.27)) "
    "(lfoot (pol 7.13 -20.64 -4.32))) (L (pol 4.50 -59.95 -6.69) (pol 9.53 59.31 -3.41)) (L "
    "(pol 21.11 -43.77 -1.45) (pol 20.15 13.95 -1.57)) (L (pol 20.18 14.10 -1.63) (pol 9.48 "
    "59.83 -3.29)) (L (pol 21.10 -43.57 -1.49) (pol 14.87 -60.06 -1.91)) (L (pol 16.36 "
    "-5.34 -1.97) (pol 16.68 -26.32 -1.77)) (L (pol 16.34 -5.48 -1.77) (pol 18.13 -5.82 "
    "-1.67)) (L (pol 16.69 -25.95 -1.73) (pol 18.42 -24.90 -1.68)) (L (pol 5.14 -23.27 "
    "-6.01) (pol 4.67 -10.12 -6.49)) (L (pol 4.67 -9.79 -6.37) (pol 3.80 2.37 -8.36)) (L "
    "(pol 3.79 2.04 -8.23) (pol 2.63 9.28 -11.67)) (L (pol 2.63 8.96 -11.95) (pol 1.51 "
    "-3.57 -20.87)) (L (pol 1.52 -3.82 -20.91) (pol 1.50 -55.68 -20.92)) (L (pol 1.50 "
    "-55.94 -20.82) (pol 1.70 -59.97 -18.44)) (L (pol 3.92 -60.12 -7.94) (pol 4.66 -50.72 "
    "-6.62)) (L (pol 4.66 -51.02 -6.39) (pol 5.13 -37.17 -6.23)) (L (pol 5.13 -37.16 -5.96) "
    "(pol 5.14 -23.25 -6.15)))(HJ (n raj1) (ax -0.00))(HJ (n raj2) (ax -0.00))(HJ (n raj3) "
    "(ax -0.00))(HJ (n raj4) (ax -0.00))(HJ (n laj1) (ax -0.00))(HJ (n laj2) (ax 0.00))(HJ "
    "(n laj3) (ax -0.00))(HJ (n laj4) (ax -0.00))(HJ (n rlj1) (ax 0.00))(HJ (n rlj2) (ax "
    "0.00))(HJ (n rlj3) (ax 0.00))(HJ (n rlj4) (ax 0.00))(HJ (n rlj5) (ax 0.00))(FRP (n rf) "
    "(c 0.00 -0.01 -0.01) (f -0.00 0.00 22.59))(HJ (n rlj6) (ax 0.00))(HJ (n llj1) (ax "
    "-0.00))(HJ (n llj2) (ax -0.00))(HJ (n llj3) (ax 0.00))(HJ (n llj4) (ax 0.00))(HJ (n "
    "llj5) (ax 0.00))(FRP (n lf) (c 0.00 -0.01 -0.01) (f 0.00 0.00 22.59))(HJ (n llj6) (ax "
    "0.00))";

TEST(RecordedFrame, TheRobotKnowsWhereItAndTheBallAreFromOneFrameOfTheReferenceServer) {
    wire::Percepts percepts;
    ASSERT_EQ(wire::decode(kFrame, percepts), 0);
    ASSERT_TRUE(percepts.see && percepts.game);
    percepts.game->unum = 1;  // told in an earlier frame
    percepts.game->team = wire::Side::Left;
    motion::State state;
    state.torso_height = 0.384;
    state.camera = {0.0, 0.0, 0.539};
    WorldModel model(WorldConfig{}, localisation::LocalisationConfig{}, 1, "Alpha");
    const Beliefs& beliefs = model.update(percepts, state, {});
    EXPECT_TRUE(beliefs.self.localised);
    EXPECT_LT((beliefs.self.pose.position - Vec2(-3.018, 0.967)).norm(), 0.05);
    EXPECT_NEAR(degrees(beliefs.self.pose.yaw), 12.4, 0.5);
    ASSERT_TRUE(beliefs.ball.known);
    EXPECT_LT(beliefs.ball.position.norm(), 0.03);
    ASSERT_EQ(beliefs.opponents.size(), 1u);
    EXPECT_EQ(beliefs.opponents[0].unum, 7);
    EXPECT_LT((beliefs.opponents[0].position - Vec2(4.0, 0.0)).norm(), 0.1);
}

}  // namespace
}  // namespace k3d::agent::world
