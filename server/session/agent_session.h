// SPDX-License-Identifier: BSD-3-Clause
// One agent's connection: what it asked for, what it is told, and its robot's senses.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "common/log/limiter.h"
#include "common/net/net.h"
#include "common/wire/commands.h"
#include "common/wire/percepts.h"
#include "server/effectors/hearing.h"
#include "server/effectors/self_collision.h"
#include "server/game/state.h"
#include "server/percepts/senses.h"

namespace k3d::server::session {

/// A place in a team, once assigned.
struct Seat {
    wire::Side team = wire::Side::None;
    int unum = 0;
};

struct AgentSession {
    AgentSession(std::unique_ptr<net::Connection> accepted, int connection_number)
        : connection(std::move(accepted)), number(connection_number) {}

    std::unique_ptr<net::Connection> connection;
    int number;                       ///< of the connection, over both ports
    net::Clock::time_point since = net::Clock::now();  ///< connected
    wire::Commands commands;          ///< of this cycle; scene and init stay until carried out
    std::optional<int> type;          ///< robot type, once `scene` was read
    std::string team_name;            ///< once `init` was read
    std::optional<Seat> seat;
    std::optional<int> player;        ///< id in the scene, once the robot stands there
    bool just_built = false;          ///< its robot senses nothing in the cycle that builds it
    std::optional<percepts::Senses> senses;
    std::optional<RandomStream> beam_noise;
    effectors::Ear ear;
    effectors::SelfCollision self_collision;
    bool lost = false;                ///< given up: closed, and its absence dealt with
    bool synced = false;              ///< has sent (syn) since the last percept
    int frames = 0;                   ///< read since the last percept
    int percepts_sent = 0;
    bool seat_told = false;           ///< GS carries unum and team once
    long damaged = 0;                 ///< expressions dropped so far
    wire::Percepts percepts;
    bool percepts_ready = false;
    std::string payload;              ///< reused buffer

    /// "left.3", or the peer's address while it has no seat.
    std::string name() const;
    /// Reads every whole frame that has arrived into `commands`.
    void read_frames(log::Limiter& notices);
    /// Whether sync and fast pace wait for its (syn): it plays, and is past its first percepts.
    bool waited_for() const;
    /// Sends the percepts generated last, if there are any and the connection is open.
    void send_percepts();
    /// Game state and hearing, which belong to the session rather than to the robot.
    void add_game_percepts(const game::GameState& state);
    /// What an agent is told while its robot does not stand in the world yet.
    void parked_percepts(double time, const game::GameState& state);
};

/// Robot type asked for: 0 for nao.rsg, N for `nao_hetero.rsg N`; none for anything else.
std::optional<int> robot_type(const wire::SceneCommand& scene);

}  // namespace k3d::server::session
