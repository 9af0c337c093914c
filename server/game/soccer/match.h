// SPDX-License-Identifier: BSD-3-Clause
// What every rule of soccer sees and changes: the scene, the state everybody is told of, and what the
// referee remembers. Field frame, m, s.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "common/field/field.h"
#include "server/game/soccer/config.h"
#include "server/game/state.h"

namespace k3d::server::game {

/// A robot's contact with the ball.
struct Touch {
    wire::Side team = wire::Side::None;
    int unum = 0;
    double time = 0.0;  ///< of Memory::now

    bool same_player(const Touch& other) const { return team == other.team && unum == other.unum; }
};

/// One team's use of pass mode.
struct PassUse {
    std::optional<double> last;        ///< when it was last in pass mode; none: no rule follows from it
    Vec3 ball = Vec3::Zero();          ///< where the ball was then
    std::optional<int> toucher;        ///< its first player to touch the ball since
    bool left_circle = false;          ///< the ball has left the circle that opponents kept free
    bool may_score = false;
};

struct Memory {
    double now = 0.0;                  ///< time of the referee, which no trainer sets
    PlayMode mode = PlayMode::BeforeKickOff;  ///< as the referee left it
    std::vector<Touch> touching;       ///< in the last step
    std::optional<Touch> last_touch;
    double mode_since = 0.0;           ///< `now` when the mode began
    Vec3 ball_before = Vec3::Zero();   ///< one step ago
    Vec3 last_ball_on_field = Vec3(0.0, 0.0, field::kBallRadius);
    Vec3 kick_spot = Vec3(0.0, 0.0, field::kBallRadius);  ///< where the next set play is taken
    bool kick_prepared = false;        ///< the ball lies there, players have room
    std::optional<Touch> kicker;       ///< took the set play; must not be next at the ball
    bool indirect = false;             ///< no goal straight from that kick
    wire::Side barred = wire::Side::None;  ///< kicked off, and may not score yet
    std::array<PassUse, 2> passes;     ///< left, right
};

struct Match {
    const SoccerConfig& config;
    GameState& state;
    body::Scene& scene;
    Memory& memory;

    void enter(PlayMode mode) {
        state.enter(mode);
        memory.mode = mode;
        memory.mode_since = memory.now;
        memory.kick_prepared = false;
    }
    void place_ball(const Vec3& spot) {
        scene.ball.move(spot);
        scene.ball.set_velocity(Vec3::Zero());
    }
    /// Somebody touched the ball after the mode began and `pause` had passed.
    bool touched_since(double pause) const {
        return memory.last_touch && memory.last_touch->time > memory.mode_since + pause;
    }
    PassUse& pass_of(wire::Side team) {
        return memory.passes[team == wire::Side::Left ? 0 : 1];
    }
    bool touches(wire::Side team) const {
        return std::any_of(memory.touching.begin(), memory.touching.end(),
                           [team](const Touch& touch) { return touch.team == team; });
    }
};

inline wire::Side opponent(wire::Side side) {
    if (side == wire::Side::None) return side;
    return side == wire::Side::Left ? wire::Side::Right : wire::Side::Left;
}

/// Modes come in pairs, the left team's first: the one of `side`.
inline PlayMode mode_for(PlayMode left_one, wire::Side side) {
    return static_cast<PlayMode>(static_cast<int>(left_one) + (side == wire::Side::Right ? 1 : 0));
}
inline bool is_either(PlayMode mode, PlayMode left_one) {
    return mode == left_one || mode == mode_for(left_one, wire::Side::Right);
}
/// Whose kick a mode of the pair is.
inline wire::Side side_in(PlayMode mode, PlayMode left_one) {
    return mode == left_one ? wire::Side::Left : wire::Side::Right;
}

}  // namespace k3d::server::game
