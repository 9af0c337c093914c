// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/trainer.h"

#include <cmath>

#include "common/field/field.h"

namespace k3d::server::game {

namespace {

struct Apply {
    body::Scene& scene;
    Game& game;
    TrainerEffect effect{};

    void operator()(const wire::BallCommand& c) {
        if (c.position) scene.ball.move(*c.position);
        if (c.velocity) scene.ball.set_velocity(*c.velocity);
    }
    void operator()(const wire::AgentCommand& c) {
        body::Player* player = scene.find(c.team, c.unum);
        if (player == nullptr || !c.position) return;
        if (c.yaw_deg) {
            // 0 means forward along world +y, which is a heading of 90 degrees.
            player->robot->place(*c.position, radians(*c.yaw_deg) + kPi / 2.0);
        } else {
            player->robot->move(*c.position);
        }
    }
    void operator()(const wire::PlayModeCommand& c) {
        if (const auto mode = play_mode(c.mode)) state(game).enter(*mode);
    }
    void operator()(const wire::KickOffCommand& c) {
        if (Soccer* soccer = std::get_if<Soccer>(&game)) soccer->kick_off(c.side);
    }
    void operator()(const wire::DropBallCommand&) { state(game).enter(PlayMode::PlayOn); }
    void operator()(const wire::TimeCommand& c) { state(game).time = c.time; }
    void operator()(const wire::ScoreCommand& c) {
        state(game).score_left = c.left;
        state(game).score_right = c.right;
    }
    void operator()(const wire::KillCommand& c) {
        if (const body::Player* player = scene.find(c.team, c.unum)) effect.killed = player->id;
    }
    void operator()(const wire::ReposCommand& c) {
        body::Player* player = scene.find(c.team, c.unum);
        if (player == nullptr) return;
        Vec3 torso = player->robot->torso_position();
        torso.y() = std::copysign(field::kWidth / 2.0 + 0.5, torso.y());
        torso.z() = field::kAgentRadius;
        player->robot->move(torso);
    }
    void operator()(const wire::FullStateCommand&) {}  // concerns the sender's stream alone
    void operator()(const wire::KillSimCommand&) { effect.end_simulation = true; }
    void operator()(const wire::TrainerSynCommand&) {}  // concerns the barrier alone
};

}  // namespace

TrainerEffect apply(const wire::TrainerCommand& command, body::Scene& scene, Game& game) {
    Apply visitor{scene, game};
    std::visit(visitor, command);
    return visitor.effect;
}

}  // namespace k3d::server::game
