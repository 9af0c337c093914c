// SPDX-License-Identifier: BSD-3-Clause
// A player forgets between matches, so that agents that stay for many play each like the first.
#include "agent/decision/player.h"

#include <gtest/gtest.h>

#include "agent/decision/keepaway/scene.h"

namespace k3d::agent::decision {
namespace {

/// Keeper 3, who is neither nearest to the ball nor next to it, at `position`.
world::Beliefs keeper_three(Vec2 position, const std::string& play_mode) {
    world::Beliefs b = test::scene(3, {position, 0.0}, {-3.0, 0.0});
    b.mates = {test::player(1, true, {-3.2, 0.0}), test::player(2, true, {-2.0, 3.0})};
    b.game.play_mode = play_mode;
    return b;
}

/// Where keeper 3 goes that stands at `position`.
Vec2 place_of(Player& player, Vec2 position) {
    return player.decide(keeper_three(position, "PlayOn"), {}, {}).account.target.value();
}

TEST(Player, IsAtHomeWhereTheMatchBegan) {
    Player player(PlayerSettings{}, test::simple_kick());
    player.decide(keeper_three({1.0, -2.0}, "BeforeKickOff"), {}, {});
    EXPECT_EQ(place_of(player, {1.0, -2.0}), Vec2(1.0, -2.0));
    EXPECT_EQ(place_of(player, {2.0, 1.0}), Vec2(1.0, -2.0));
    player.decide(keeper_three({2.0, 1.0}, "GameOver"), {}, {});
    player.decide(keeper_three({2.0, 1.0}, "BeforeKickOff"), {}, {});
    EXPECT_EQ(place_of(player, {2.0, 1.0}), Vec2(2.0, 1.0));
    EXPECT_EQ(place_of(player, {3.0, -3.0}), Vec2(2.0, 1.0));
}

}  // namespace
}  // namespace k3d::agent::decision
