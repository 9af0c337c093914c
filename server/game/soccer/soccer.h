// SPDX-License-Identifier: BSD-3-Clause
// Soccer as the reference server judges it (reference 7.2), fouls between players left out. Soccer is
// the list of rules; each is a file of this folder.
#pragma once

#include <array>
#include <string>

#include "common/episode/result.h"
#include "server/game/soccer/match.h"

namespace k3d::server::game {

class Soccer {
  public:
    explicit Soccer(const SoccerConfig& config) : config_(config) {}

    GameState& state() { return state_; }
    const GameState& state() const { return state_; }

    void before_step(body::Scene&) {}
    void after_step(body::Scene& scene);
    /// A trainer's `(kickOff Left|Right|None)`: None gives it to the left team in the first half, else right.
    void kick_off(wire::Side side);
    /// A trainer's `(dropBall)`: where it is.
    void drop_ball(body::Scene& scene);
    /// A player's `(pass)`.
    void pass(body::Scene& scene, const body::Player& player);

    /// Ends the match from outside the rules (physics failed).
    void abort(episode::Status status, const std::string& reason);

    /// Beam is allowed in BeforeKickOff and after goals.
    bool beam_allowed() const { return paused(state_.mode); }
    bool over() const { return aborted() || (config_.ends && state_.mode == PlayMode::GameOver); }
    /// Without seed, state hash and code version, which the caller knows.
    episode::Result result() const;

    /// Where the next new player of a team waits: slots go by order of coming, not by number (reference
    /// 1.6). Torso's field position.
    Vec3 next_start_slot(wire::Side team);

  private:
    void judge(Match& match);
    bool aborted() const { return status_ != episode::Status::Finished; }

    SoccerConfig config_;
    GameState state_;
    Memory memory_;
    std::array<int, 2> slots_used_{};  ///< left, right
    episode::Status status_ = episode::Status::Finished;
    std::string reason_ = "time_limit";
};

}  // namespace k3d::server::game
