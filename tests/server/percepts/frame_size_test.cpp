// SPDX-License-Identifier: BSD-3-Clause
// The longest frame of a match fits the buffers of foreign agents.
#include <gtest/gtest.h>

#include "common/wire/frame.h"
#include "server/percepts/senses.h"
#include "server/session/teams.h"

namespace k3d::server::percepts {
namespace {

TEST(FrameSize, AllRobotsAllLinesAndLongNamesFitOneFrame) {
    body::Scene scene;
    constexpr int kPlayers = 22;
    constexpr int kToes = 4;
    for (int k = 0; k < kPlayers; ++k) {
        body::Player& player = scene.add_player(kToes, {0, 0, 1});
        player.team = k < 11 ? wire::Side::Left : wire::Side::Right;
        player.unum = k % 11 + 1;
        player.team_name = std::string(session::kMaxTeamName, k < 11 ? 'a' : 'b');
        player.robot->place({1.0 * (k % 11), k < 11 ? -3.0 : 3.0, 0.385}, 0.0);
    }
    // The last one sees everything from behind the field, its own arms included.
    body::Player& self = *scene.players.back();
    self.robot->place({-25, 0, 0.385}, 0.0);
    const VisionConfig everything{.my_position = true, .my_orientation = true, .ball_position = true};
    Senses senses(everything, RandomStream(1, "right.11", "vision"));
    wire::Percepts percepts;
    senses.before_step(self);
    senses.after_step(scene, self, 12345.67, percepts);
    percepts.game = wire::GameState{.unum = 11, .team = wire::Side::Right, .score_left = 11,
                                    .score_right = 22, .time = 1234.56,
                                    .play_mode = "direct_free_kick_right"};
    for (auto& foot : percepts.feet) foot = {{-0.04, -0.16, -0.01}, {-1234.5, -1234.5, -1234.5}};
    for (int k = 0; k < 3; ++k) {
        percepts.heard.push_back({self.team_name, 1234.56, -123.45, std::string(20, 'x')});
    }
    ASSERT_EQ(percepts.see->players.size(), 22U);
    ASSERT_EQ(percepts.see->lines.size(), 21U);
    std::string payload;
    wire::encode(percepts, self.robot->model(), payload);
    EXPECT_GT(payload.size(), 7000U) << "no longer the worst case";
    EXPECT_LE(payload.size(), wire::kMaxPayloadToAgent);
}

}  // namespace
}  // namespace k3d::server::percepts
