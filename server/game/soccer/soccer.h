// SPDX-License-Identifier: BSD-3-Clause
// Soccer as far as a single team's training and friendly play need it (reference 7.2): clock,
// BeforeKickOff, kick-off, goals, halves. Balls out of play and fouls are not judged.
#pragma once

#include "common/config/fields.h"
#include "server/game/state.h"

namespace k3d::server::game {

struct SoccerConfig {
    double half_time = 300.0;
    bool type_quotas = true;

    void describe(config::Fields& f) {
        f.number("half_time", half_time, {1.0, 36000.0}, "s", "length of each of the two halves");
        f.boolean("type_quotas", type_quotas,
                  "a team has at most 7 robots of one type and 9 of two types, and 3 types in all");
    }
};

class Soccer {
  public:
    explicit Soccer(const SoccerConfig& config) : config_(config) {}

    GameState& state() { return state_; }
    const GameState& state() const { return state_; }

    void before_step(body::Scene& scene);
    void after_step(body::Scene& scene);
    /// `(kickOff Left|Right|None)`: None gives it to the left team in the first half, else right.
    void kick_off(wire::Side side);

    /// Beam is allowed in BeforeKickOff and after goals.
    bool beam_allowed() const;
    bool over() const { return state_.mode == PlayMode::GameOver; }

    /// Where a new player of this number waits (reference 1.6); torso's field position.
    static Vec3 start_slot(wire::Side team, int unum);

  private:
    void keep_own_halves(body::Scene& scene, wire::Side kicking);
    void check_goal(body::Scene& scene);

    SoccerConfig config_;
    GameState state_;
};

}  // namespace k3d::server::game
