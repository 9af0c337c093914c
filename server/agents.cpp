// SPDX-License-Identifier: BSD-3-Clause
// Simulation: what agents' commands do, and how agents come and go.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "common/log/log.h"
#include "server/cycle.h"
#include "server/game/trainer.h"

namespace k3d::server {

void Simulation::say_left(const session::AgentSession& agent, const std::string& why) {
    const auto level = agent.connection->broke_limit() ? spdlog::level::warn : spdlog::level::info;
    if (agent.seat) {
        spdlog::log(level, "{} left: {}", agent.name(), why);
    } else {
        notices_.say(level, "{} left: {}", agent.name(), why);
    }
}

void Simulation::accept_agent(std::unique_ptr<net::Connection> accepted) {
    // Strangers may come and go by the thousand while a cycle waits.
    std::erase_if(agents_, [this](const auto& agent) {
        const bool gone = agent->connection->spent() && !agent->seat && !agent->player;
        if (gone && !agent->lost) {
            say_left(*agent, agent->connection->close_reason());
            if (recorder_) recorder_->left(agent->number, agent->connection->close_reason());
        }
        return gone;
    });
    const int number = next_connection_++;
    if (recorder_) {
        const std::string peer = accepted->peer();
        accepted = recorder_->tap(std::move(accepted),
                                  {number, recording::Port::Agent, false, peer});
    }
    agents_.push_back(std::make_unique<session::AgentSession>(std::move(accepted), number));
}

void Simulation::accept_monitor(std::unique_ptr<net::Connection> accepted) {
    const int number = next_connection_++;
    const std::string peer = accepted->peer();
    const bool commands = session::may_command(config_.network.trainers, peer);
    if (recorder_) {
        accepted = recorder_->tap(std::move(accepted),
                                  {number, recording::Port::Monitor, commands, peer});
    }
    monitors_.accept(std::move(accepted), number, commands);
}

bool Simulation::everybody_synced() {
    bool everybody = !serves_monitors() || monitors_.read();
    for (const auto& agent : agents_) {
        agent->read_frames(notices_);  // of newcomers too: their faults must not wait for the others
        everybody = everybody && (!agent->waited_for() || agent->synced);
    }
    return everybody;
}

void Simulation::drop_closed_agents() {
    const auto now = net::Clock::now();
    for (const auto& agent : agents_) {
        const std::chrono::duration<double> age = now - agent->since;
        if (replayed_ == nullptr && !agent->seat && age.count() > config_.network.handshake) {
            agent->connection->close(fmt::format("no seat after {:.0f} s, limit {:g} s",
                                                 age.count(), config_.network.handshake));
        }
        if (agent->connection->closed() && !agent->lost) {
            lose(*agent, agent->connection->close_reason());
        }
    }
    std::erase_if(agents_, [](const auto& agent) { return agent->connection->closed(); });
}

void Simulation::lose(session::AgentSession& agent, const std::string& why) {
    const std::string name = agent.name();
    say_left(agent, why);
    if (recorder_) recorder_->left(agent.number, why);
    agent.connection->close(why);
    agent.lost = true;
    if (agent.seat) teams_.release(*agent.seat);
    auto* keepaway = std::get_if<game::Keepaway>(&game_);
    if (agent.player && keepaway != nullptr && !keepaway->over()) {
        keepaway->abort(episode::Status::AgentLost, name + ": " + why);
        agent.player.reset();  // the robot stays where it is until the episode's end
    } else {
        remove_player(agent);
    }
}

void Simulation::remove_player(session::AgentSession& agent) {
    if (agent.player) scene_->remove_player(*agent.player);
    agent.player.reset();
}

/// A keepaway episode that goes on short of a player would count as one of its own kind.
void Simulation::kill(session::AgentSession& agent) {
    if (auto* keepaway = std::get_if<game::Keepaway>(&game_)) {
        keepaway->abort(episode::Status::AgentLost, agent.name() + ": killed by a trainer");
    }
    remove_player(agent);
}

void Simulation::load_robot(session::AgentSession& agent) {
    const wire::SceneCommand& scene = *agent.commands.scene;
    const auto type = session::robot_type(scene);
    if (agent.type) {
        notices_.say(spdlog::level::warn, "{}: a second scene is ignored", agent.name());
    } else if (!type) {
        notices_.say(spdlog::level::warn, "{}: robot type '{}' is not in 0..{}", agent.name(),
                     log::printable(scene.arguments.front()), nao::kTypeCount - 1);
    } else if (!lobby_ && config_.game == "keepaway") {
        // A further robot would stand in everybody's way, and none can take a seat now.
        notices_.say(spdlog::level::warn, "{}: no robot, the match has begun", agent.name());
    } else {
        agent.type = *type;
        if (!lobby_) {
            // The reference builds every robot at this spot, whence it drops until placed.
            agent.player = scene_->add_player(*type, {0.0, -1.0, 1.5}).id;
            agent.just_built = true;
            begin_percepts(agent);
        }
    }
    agent.commands.scene.reset();
}

void Simulation::take_seat(session::AgentSession& agent) {
    const wire::InitCommand init = *agent.commands.init;
    agent.commands.init.reset();
    if (agent.seat) {
        notices_.say(spdlog::level::warn, "{}: a second init is ignored", agent.name());
        return;
    }
    const auto seat = teams_.assign(init, *agent.type);
    if (!seat) {
        notices_.say(spdlog::level::warn, "{} gets no seat: {}", agent.name(), seat.error());
        return;
    }
    agent.team_name = init.team;
    agent.seat = *seat;
    spdlog::info("{} is {} of team '{}'", agent.connection->peer(), agent.name(), init.team);
    game::GameState& state = game::state(game_);
    state.team_left = teams_.left();
    state.team_right = teams_.right();
    if (!agent.player) return;
    body::Player& player = *scene_->find(*agent.player);
    player.team = seat->team;
    player.unum = seat->unum;
    player.team_name = init.team;
    line_up(agent);
}

/// Where a soccer player stands until it beams.
void Simulation::line_up(const session::AgentSession& agent) {
    auto* soccer = std::get_if<game::Soccer>(&game_);
    if (soccer == nullptr) return;
    const wire::Side team = agent.seat->team;
    const double heading = team == wire::Side::Left ? 0.0 : kPi;
    scene_->find(*agent.player)->robot->place(soccer->next_start_slot(team), heading);
}

void Simulation::act(session::AgentSession& agent) {
    wire::Commands& commands = agent.commands;
    if (agent.player) {
        body::Robot& robot = *scene_->find(*agent.player)->robot;
        for (std::size_t j = 0; j < nao::kJointCount; ++j) {
            if (const auto& rate = commands.joint_rates[j]) {
                const auto joint = static_cast<nao::JointId>(j);
                robot.drive(joint, agent.self_collision.frozen(joint) ? 0.0 : *rate);
            }
        }
        for (const std::string& text : commands.say) say(agent, text);
    }
    commands.joint_rates = {};
    commands.say.clear();
    commands.syn = false;
}

void Simulation::say(session::AgentSession& agent, const std::string& text) {
    const body::Player& speaker = *scene_->find(*agent.player);
    if (!agent.seat || !effectors::sayable(text)) return;
    const double time = game::state(game_).time;
    agent.ear.hear_self(text, time, speaker.team_name);
    for (const auto& other : agents_) {
        if (other.get() == &agent || !other->player || !other->seat) continue;
        other->ear.hear_other(*scene_->find(*other->player), speaker, text, time);
    }
}

void Simulation::judge_self_collisions() {
    if (!config_.self_collision.freezes) return;
    const bool paused = game::paused(game::state(game_).mode);
    for (const auto& agent : agents_) {
        if (!agent->player || !agent->seat) continue;
        if (paused) {
            agent->self_collision.release();
        } else if (agent->self_collision.judge(*scene_->find(*agent->player)->robot,
                                               clock_.seconds())) {
            spdlog::debug("{}: limbs overlap and are frozen at {:.2f} s", agent->name(),
                          clock_.seconds());
        }
    }
}

void Simulation::carry_out_stored_commands() {
    for (const auto& agent : agents_) {
        // init needs the robot that scene built in an earlier cycle (reference 1.5).
        const bool loaded_before = agent->type.has_value();
        if (agent->commands.scene) load_robot(*agent);
        if (agent->commands.init && loaded_before) take_seat(*agent);
        agent->commands.init.reset();
        if (agent->commands.beam && agent->player && agent->seat && game::beam_allowed(game_)) {
            effectors::beam(*scene_->find(*agent->player), *agent->commands.beam, config_.beam,
                            *agent->beam_noise);
        }
        agent->commands.beam.reset();
        auto* soccer = std::get_if<game::Soccer>(&game_);
        if (std::exchange(agent->commands.pass, false) && agent->player && soccer != nullptr) {
            soccer->pass(*scene_, *scene_->find(*agent->player));
        }
    }
}

void Simulation::say_ignored(const session::Order& order, std::string_view why) {
    std::string text;
    wire::encode(order.command, text);
    notices_.say(spdlog::level::warn, "trainer at {}: {} ignored, {}", order.peer,
                 log::printable(text), why);
}

void Simulation::obey_trainers() {
    if (!serves_monitors()) return;
    monitors_.read();
    for (const session::Order& order : monitors_.take_commands()) {
        const game::TrainerEffect effect = game::apply(order.command, *scene_, game_);
        end_ = end_ || effect.end_simulation;
        if (!effect.ignored.empty()) say_ignored(order, effect.ignored);
        if (!effect.killed) continue;
        for (const auto& agent : agents_) {
            if (agent->player == effect.killed) kill(*agent);
        }
    }
}

}  // namespace k3d::server
