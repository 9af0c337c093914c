// SPDX-License-Identifier: BSD-3-Clause
#include "server/session/agent_session.h"

#include "common/log/log.h"
#include "common/sexpr/reader.h"
#include "common/wire/frame.h"

namespace k3d::server::session {

namespace {

/// An agent with fewer percepts than this counts as synced (reference 2.3): it is still starting.
constexpr int kGracePercepts = 5;

}  // namespace

std::string AgentSession::name() const {
    if (!seat) return "agent at " + connection->peer();
    return std::string(wire::side_name(seat->team)) + "." + std::to_string(seat->unum);
}

bool AgentSession::waited_for() const {
    // Who has no seat is waited for no longer than by its handshake's deadline: not at all.
    return seat && player && !connection->closed() && percepts_sent >= kGracePercepts;
}

void AgentSession::read_frames(log::Limiter& notices) {
    std::string_view frame;
    while (connection->next_frame(frame)) {
        ++frames;
        const int bad = wire::decode(frame, commands);
        if (bad > 0) {
            // Once per connection at warning level: a foreign agent may send extras every cycle.
            const auto level = damaged == 0 ? spdlog::level::warn : spdlog::level::debug;
            notices.say(level, "{}: {} unknown or damaged expressions ignored in \"{}\"", name(),
                        bad, log::printable(frame));
            damaged += bad;
        }
    }
    if (commands.syn) synced = true;
}

void AgentSession::send_percepts() {
    if (!percepts_ready || connection->closed() || !type) return;
    payload.clear();
    wire::encode(percepts, nao::model(*type), payload);
    if (payload.size() > wire::kMaxPayloadToAgent && percepts.see) {
        // A sight of all 22 fits (teams.h) and a trainer's coordinates are bounded; should bodies
        // be so far away that their numbers are longer, no sight is better than a frame that no
        // agent takes.
        spdlog::warn("{}: a frame of {} bytes is sent without what is seen", name(), payload.size());
        percepts.see.emplace();
        payload.clear();
        wire::encode(percepts, nao::model(*type), payload);
    }
    K3D_ASSERT(payload.size() <= wire::kMaxPayloadToAgent);
    connection->send(payload);
    percepts_ready = false;
    synced = false;
    frames = 0;
    ++percepts_sent;
}

void AgentSession::add_game_percepts(const game::GameState& state) {
    wire::GameState& gs = percepts.game.emplace();
    gs.score_left = state.score_left;
    gs.score_right = state.score_right;
    gs.time = state.time;
    gs.play_mode = game::name(state.mode);
    if (seat && !seat_told) {
        gs.unum = seat->unum;
        gs.team = seat->team;
        seat_told = true;
    }
    ear.collect(percepts.heard);
    percepts_ready = true;
}

void AgentSession::parked_percepts(double time, const game::GameState& state) {
    percepts = {};
    percepts.time = time;
    percepts.acceleration = {0.0, 0.0, 9.81};
    for (const nao::JointDef& joint : nao::model(*type).joints) {
        percepts.has_joint.set(nao::index(joint.id));
    }
    add_game_percepts(state);
}

std::optional<int> robot_type(const wire::SceneCommand& scene) {
    if (scene.arguments.empty()) return 0;
    const auto type = sexpr::to_integer(scene.arguments.front());
    if (!type || !nao::is_type(*type)) return std::nullopt;
    return *type;
}

}  // namespace k3d::server::session
