// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/trainer.h"

#include <algorithm>

#include "server/game/clearing.h"

namespace k3d::server::game {

namespace {

constexpr std::string_view kNoPlayer = "there is no such player";
constexpr std::string_view kNobodySelected = "no player is selected";
constexpr std::string_view kNoMode = "there is no such play mode";
constexpr std::string_view kKeepaway = "keepaway keeps its own time and play modes";

struct Apply {
    body::Scene& scene;
    Game& game;
    TrainerEffect effect{};

    void operator()(const wire::BallCommand& c) {
        if (c.position) scene.ball.move(*c.position);
        if (c.velocity) scene.ball.set_velocity(*c.velocity);
    }
    void operator()(const wire::AgentCommand& c) {
        body::Player* player = found(scene.find(c.team, c.unum));
        if (player == nullptr || !c.position) return;
        if (c.yaw_deg) {
            // 0 means forward along world +y, which is a heading of 90 degrees.
            player->robot->place(*c.position, radians(*c.yaw_deg) + kPi / 2.0);
        } else {
            player->robot->move(*c.position);
        }
    }
    void operator()(const wire::PlayModeCommand& c) {
        const auto mode = play_mode(c.mode);
        Soccer* referee = soccer();
        if (referee == nullptr) return;
        if (!mode) {
            effect.ignored = kNoMode;
            return;
        }
        referee->state().enter(*mode);
    }
    void operator()(const wire::KickOffCommand& c) {
        if (Soccer* referee = soccer()) referee->kick_off(c.side);
    }
    void operator()(const wire::DropBallCommand&) {
        if (Soccer* referee = soccer()) referee->drop_ball(scene);
    }
    void operator()(const wire::TimeCommand& c) {
        if (Soccer* referee = soccer()) referee->state().time = c.time;
    }
    void operator()(const wire::ScoreCommand& c) {
        state(game).score_left = c.left;
        state(game).score_right = c.right;
    }
    void operator()(const wire::ClearSelectedCommand&) {
        body::Player* player = found(selected(), kNobodySelected);
        if (player == nullptr) return;
        const Vec3 torso = player->robot->torso_position();
        player->robot->move(sent_back(torso, torso, player->team));
    }
    void operator()(const wire::KillCommand& c) {
        if (const body::Player* player = meant(c)) effect.killed = player->id;
    }
    void operator()(const wire::ReposCommand& c) {
        body::Player* player = meant(c);
        if (player == nullptr) return;
        player->robot->move(beside_field(scene.ball.position(), player->unum, player->team));
    }
    void operator()(const wire::SelectCommand& c) {
        using Who = wire::SelectCommand::Who;
        const body::Player* next =
            c.who == Who::Player ? found(scene.find(c.team, c.unum)) : nullptr;
        if (c.who == Who::Player && next == nullptr) return;
        if (c.who == Who::Next) next = after_selected();
        for (const auto& player : scene.players) player->selected = player.get() == next;
    }
    void operator()(const wire::FullStateCommand&) {}  // concerns the sender's stream alone
    void operator()(const wire::KillSimCommand&) { effect.end_simulation = true; }
    void operator()(const wire::TrainerSynCommand&) {}  // concerns the barrier alone
    void operator()(const wire::IdleCommand&) {}

    /// Who obeys the commands that decide over the course of a match; keepaway's referee does not.
    Soccer* soccer() {
        Soccer* referee = std::get_if<Soccer>(&game);
        if (referee == nullptr) effect.ignored = kKeepaway;
        return referee;
    }
    /// The player, who is to be there.
    body::Player* found(body::Player* player, std::string_view otherwise = kNoPlayer) {
        if (player == nullptr) effect.ignored = otherwise;
        return player;
    }
    body::Player* selected() {
        const auto it = std::find_if(scene.players.begin(), scene.players.end(),
                                     [](const auto& player) { return player->selected; });
        return it == scene.players.end() ? nullptr : it->get();
    }
    /// The player that kill or repos names, or the selected one.
    template <class Command>
    body::Player* meant(const Command& c) {
        return c.selected ? found(selected(), kNobodySelected) : found(scene.find(c.team, c.unum));
    }
    /// The player behind the selected one, else the first.
    const body::Player* after_selected() {
        const auto& players = scene.players;
        if (players.empty()) return nullptr;
        const body::Player* now = selected();
        for (std::size_t i = 0; i + 1 < players.size(); ++i) {
            if (players[i].get() == now) return players[i + 1].get();
        }
        return players.front().get();
    }
};

}  // namespace

TrainerEffect apply(const wire::TrainerCommand& command, body::Scene& scene, Game& game) {
    Apply visitor{scene, game};
    std::visit(visitor, command);
    return visitor.effect;
}

}  // namespace k3d::server::game
