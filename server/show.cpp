// SPDX-License-Identifier: BSD-3-Clause
// Simulation: what monitors and the page are shown, made only while somebody watches.
#include "server/cycle.h"

namespace k3d::server {

void Simulation::show() {
    tell_monitors();
    log_for_monitors();
    show_page();
}

bool Simulation::serves_monitors() const {
    constexpr int kMonitorCycles = 2;  // the monitor port is served every 40 ms (reference 2.4)
    return clock_.count % kMonitorCycles == 0;
}

void Simulation::tell_monitors() {
    if (!in_lobby() && !serves_monitors()) return;
    const monitor::GameView view = monitor::view_of(game::state(game_), config_.soccer.half_time);
    if (monitors_.watched()) {
        graph_.update(*scene_);
        if (frames_.restart(graph_, view)) monitors_.require_full();
    }
    const session::FrameSource source{[&] { return frames_.full(graph_, view); },
                                      [&] { return frames_.difference(graph_, view); }};
    if (in_lobby()) {
        monitors_.greet(source);  // time stands still
    } else {
        monitors_.send(source);
    }
}

void Simulation::log_for_monitors() {
    if (!monitor_log_ || in_lobby() || !monitor_log_->due(clock_)) return;
    graph_.update(*scene_);
    monitor_log_->add(clock_, graph_,
                      monitor::view_of(game::state(game_), config_.soccer.half_time));
}

void Simulation::show_page() {
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
    if (config_.game == "keepaway") {
        const auto* keepaway = std::get_if<game::Keepaway>(&game_);
        view_.area = Vec2::Constant(keepaway != nullptr ? keepaway->side()
                                                        : config_.keepaway.start_side());
    }
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
