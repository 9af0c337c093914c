// SPDX-License-Identifier: BSD-3-Clause
// One 20 ms frame, in the reference's order (2.1): what is read now acts at once, what was sensed
// at the end of the last cycle is sent now; hence the protocol's one cycle of latency.
#include "server/cycle.h"

#include <utility>

#include "common/log/log.h"

namespace k3d::server {

void Simulation::run_cycle() {
    stages_.enter(Stage::Wire);
    // 1. Commands that have arrived: joint rates, say and syn act at once. By pace, wait for all.
    read_commands();
    if (cut_short_) return;
    // 2. The percepts generated at the end of the cycle before.
    send_percepts();
    stages_.enter(Stage::Rules);
    // 3. Before the physics: what was stored (scene, init, beam), trainers, velocity sensors.
    carry_out_stored_commands();
    obey_trainers();
    for (const auto& agent : agents_) {
        if (agent->player) agent->senses->before_step(*scene_->find(*agent->player));
    }
    game::before_step(game_, *scene_);
    // 4, 5. Collide and step.
    step_physics();
    stages_.enter(Stage::Rules);
    // 6. Rules and counters.
    update_game();
    // 7. The clock.
    ++clock_;
    ++cycles_measured_;
    stages_.enter(Stage::Percepts);
    // 8. Percepts for the next cycle; monitors and the page.
    sense();
    stages_.enter(Stage::Shown);
    show();
}

void Simulation::read_commands() {
    if (replayed_ != nullptr) {
        replay_inputs();
    } else {
        await_inputs();
    }
    if (cut_short_) return;
    drop_closed_agents();
    for (const auto& agent : agents_) {
        agent->read_frames(notices_);
        act(*agent);
    }
    begin_input_cycle();
}

void Simulation::await_inputs() {
    pacer_.wait_for_clock(loop_);
    if (pacer_.waits_for_agents()) doze();
    if (!pacer_.waits_for_agents() ||
        pacer_.wait_for_agents(loop_, [this] { return all_have_come(); })) {
        return;
    }
    for (const auto& agent : agents_) {
        if (agent->waited_for() && !agent->synced) lose(*agent, "hung");
    }
    if (serves_monitors()) monitors_.close_hung();
}

/// Or the wait is to end without them: a cycle that some have no part in would be none of the
/// match.
bool Simulation::all_have_come() {
    cut_short_ = *stop_ != 0;
    return cut_short_ || everybody_synced();
}

/// Agents get their frames in order, so the last one's reply mostly is the last: waking once for it costs a
/// fifth of waking for each.
void Simulation::doze() {
    constexpr std::chrono::milliseconds kLongest{5};
    for (auto agent = agents_.rbegin(); agent != agents_.rend(); ++agent) {
        if (!(*agent)->waited_for() || (*agent)->synced) continue;
        (*agent)->connection->doze(kLongest);
        return;
    }
}

void Simulation::send_percepts() {
    for (const auto& agent : agents_) agent->send_percepts();
}

void Simulation::step_physics() {
    try {
        scene_->world.step(&stages_);
        hash_ = scene_->world.hash(hash_);
    } catch (const physics::Diverged& error) {
        spdlog::error("physics diverged at {:.2f} s: {}", clock_.seconds(), error.what());
        game::abort(game_, episode::Status::Diverged, error.what());
        cycles_since_over_ = kGameOverCycles;  // no further step of a broken world
    }
}

void Simulation::update_game() {
    game::after_step(game_, *scene_);
    judge_self_collisions();
    if (game::over(game_)) finish_episode();
}

void Simulation::sense() {
    const game::GameState& state = game::state(game_);
    for (const auto& agent : agents_) {
        if (!agent->player || std::exchange(agent->just_built, false)) continue;
        const body::Player& self = *scene_->find(*agent->player);
        agent->senses->after_step(*scene_, self, clock_.seconds(), agent->percepts);
        agent->add_game_percepts(state);
    }
}

}  // namespace k3d::server
