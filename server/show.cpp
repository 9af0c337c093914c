// SPDX-License-Identifier: BSD-3-Clause
// Simulation: what the page is shown, only while somebody watches.
#include "server/cycle.h"

namespace k3d::server {

void Simulation::show() {
    if (!viewer_ || !viewer_->watched()) return;
    const game::GameState& state = game::state(game_);
    view_.time = clock_.seconds();
    view_.game_time = state.time;
    view_.play_mode = game::name(state.mode);
    view_.team_left = teams_.left();
    view_.team_right = teams_.right();
    view_.score_left = state.score_left;
    view_.score_right = state.score_right;
    view_.episode = config_.first_episode + episode_ - 1;
    view_.ball = {scene_->ball.position(), scene_->ball.rotation()};
    view_.area.reset();
    if (config_.game == "keepaway") view_.area = Vec2::Constant(config_.keepaway.side);
    view_.robots.resize(scene_->players.size());
    for (std::size_t i = 0; i < scene_->players.size(); ++i) {
        const body::Player& player = *scene_->players[i];
        viewer::RobotView& robot = view_.robots[i];
        robot.team = player.team;
        robot.unum = player.unum;
        robot.type = player.robot->model().type;
        robot.parts.resize(player.robot->model().bodies.size());
        for (std::size_t k = 0; k < robot.parts.size(); ++k) {
            robot.parts[k] = {player.robot->position(k), player.robot->rotation(k)};
        }
    }
    viewer_->publish(view_);
}

}  // namespace k3d::server
