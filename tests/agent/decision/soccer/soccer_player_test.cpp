// SPDX-License-Identifier: BSD-3-Clause
// Who goes to the ball, who keeps the formation, and whose ball it is.
#include "agent/decision/soccer/soccer_player.h"

#include <gtest/gtest.h>

#include "agent/decision/keepaway/scene.h"
#include "agent/decision/soccer/formation.h"

namespace k3d::agent::decision {
namespace {

using namespace test;

class Soccer : public ::testing::Test {
  protected:
    SoccerPlayer plays{{}, {}, simple_kick(), RandomStream(1, "test", "soccer")};
    motion::State standing;
};

TEST_F(Soccer, TheNearestGoesToTheBallAndTheOthersKeepTheirPlaces) {
    world::Beliefs b = scene(10, {{-2.5, 0.0}, 0.0}, {0.0, 0.0});
    b.mates = {test::player(9, true, {-2.5, -3.5}, 10.0)};
    EXPECT_EQ(plays.decide(b, standing).account.role, "striker");
    b.mates[0].position = {-0.5, 0.0};
    EXPECT_EQ(plays.decide(b, standing).account.role, "place");
    b.mates[0].fallen = true;
    EXPECT_EQ(plays.decide(b, standing).account.role, "striker") << "who lies there plays nothing";
}

TEST_F(Soccer, KicksTowardsTheOpponentsGoal) {
    const world::Beliefs b = scene(10, {{2.8, 0.0}, 0.0}, {3.0, 0.0});
    plays.decide(b, standing);  // a state changes one call after it was chosen
    const Decision d = plays.decide(b, standing);
    EXPECT_TRUE(is_kick(d.request.body)) << d.account.skill;
    EXPECT_GT(d.account.target->x(), 15.0);
}

TEST_F(Soccer, LeavesTheOthersSetPlaysAlone) {
    EXPECT_TRUE(is_theirs("KickIn_Right", wire::Side::Left));
    EXPECT_TRUE(is_theirs("corner_kick_left", wire::Side::Right));
    EXPECT_FALSE(is_theirs("KickOff_Left", wire::Side::Left));
    EXPECT_FALSE(is_theirs("PlayOn", wire::Side::Left));
    world::Beliefs b = scene(10, {{-2.5, 0.0}, 0.0}, {0.0, 0.0});
    b.game.play_mode = "KickOff_Right";
    EXPECT_EQ(plays.decide(b, standing).account.role, "place");
}

TEST_F(Soccer, TheGoalkeeperStaysAtItsGoal) {
    world::Beliefs b = scene(1, {{-14.0, 0.0}, 0.0}, {-5.0, 0.0});
    EXPECT_EQ(plays.decide(b, standing).account.role, "place");
    b.ball.position = b.ball.finish = {-13.0, 0.5};
    EXPECT_EQ(plays.decide(b, standing).account.role, "striker");
}

TEST(Formation, StandsInTheOwnHalfOutsideTheCircle) {
    for (int unum = 1; unum <= 11; ++unum) {
        EXPECT_LT(kick_off_place(unum).x(), -1.0);
        EXPECT_GT(kick_off_place(unum).norm(), 2.2);
    }
    EXPECT_GT(place_in_play(9, {8.0, 0.0}).x(), 0.0) << "moves up with the ball";
    EXPECT_NEAR(place_in_play(1, {8.0, 5.0}).x(), -14.0, 1e-9);
}

}  // namespace
}  // namespace k3d::agent::decision
