// SPDX-License-Identifier: BSD-3-Clause
#include "contract/minds_rig.h"

#include "common/clock/clock.h"

namespace k3d::contract {

namespace {

server::game::KeepawayConfig config_of(int keepers, int takers) {
    server::game::KeepawayConfig config;
    config.keepers = keepers;
    config.takers = takers;
    return config;
}

std::unique_ptr<server::body::Scene> scene_of(const server::game::KeepawayConfig& config) {
    auto scene = std::make_unique<server::body::Scene>();
    for (int k = 0; k < config.keepers + config.takers; ++k) {
        server::body::Player& player = scene->add_player(0, {0.0, 0.0, 1.0});
        const bool keeper = k < config.keepers;
        player.team = keeper ? wire::Side::Left : wire::Side::Right;
        player.unum = keeper ? k + 1 : k - config.keepers + 1;
        player.team_name = keeper ? "Keepers" : "Takers";
    }
    return scene;
}

}  // namespace

MindsRig::MindsRig(int keepers, int takers, std::uint64_t seed)
    : config_(config_of(keepers, takers)),
      scene_(scene_of(config_)),
      game_(config_, seed, *scene_) {
    agent::Config settings;
    settings.keepaway.keepers = keepers;
    for (const auto& player : scene_->players) {
        Seat& seat = seats_.emplace_back();
        seat.id = player->id;
        seat.senses = std::make_unique<server::percepts::Senses>(
            server::percepts::VisionConfig{}, RandomStream(seed, player->entity(), "vision"));
        seat.mind = std::make_unique<agent::Mind>(
            settings, agent::Seat{player->team_name, player->unum}, std::string());
    }
    for (Seat& seat : seats_) tell(seat);
}

void MindsRig::tell(Seat& seat) {
    const server::body::Player& self = *scene_->find(seat.id);
    seat.senses->after_step(*scene_, self, time_, seat.percepts);
    wire::GameState& state = seat.percepts.game.emplace();
    state.time = game_.state().time;
    state.play_mode = server::game::name(game_.state().mode);
    if (!seat.told) {
        state.unum = self.unum;
        state.team = self.team;
        seat.told = true;
    }
    seat.ear.collect(seat.percepts.heard);
    seat.payload.clear();
    wire::encode(seat.percepts, nao::model(0), seat.payload);
}

void MindsRig::obey(Seat& seat) {
    seat.commands = {};
    wire::decode(seat.reply, seat.commands);
    const server::body::Player& self = *scene_->find(seat.id);
    for (std::size_t j = 0; j < nao::kJointCount; ++j) {
        if (const auto& rate = seat.commands.joint_rates[j]) {
            self.robot->drive(static_cast<nao::JointId>(j), *rate);
        }
    }
    for (const std::string& text : seat.commands.say) {
        for (Seat& other : seats_) {
            if (other.id == seat.id) continue;
            other.ear.hear_other(*scene_->find(other.id), self, text, game_.state().time);
        }
    }
}

void MindsRig::step(const std::function<void(Seat&)>& think) {
    // As the server does it: what was replied to the frame before acts now, what was sensed at the
    // end of the last cycle is sent now.
    for (Seat& seat : seats_) obey(seat);
    for (Seat& seat : seats_) think(seat);
    for (Seat& seat : seats_) seat.senses->before_step(*scene_->find(seat.id));
    game_.before_step(*scene_);
    scene_->world.step();
    game_.after_step(*scene_);
    time_ += kCycleSeconds;
    for (Seat& seat : seats_) tell(seat);
}

}  // namespace k3d::contract
