// SPDX-License-Identifier: BSD-3-Clause
// The keepaway game: start, referee and result, what the paper's and the league's rules share.
//
// Left team = keepers, right team = takers. BeforeKickOff for a while, then PlayOn, from which
// hold time counts, GameOver when a rule ends it. Judged by ground truth alone.
#pragma once

#include <optional>
#include <string>

#include "common/episode/result.h"
#include "server/game/keepaway/config.h"
#include "server/game/keepaway/pass_counter.h"
#include "server/game/keepaway/player_log.h"
#include "server/game/keepaway/start.h"
#include "server/game/state.h"

namespace k3d::server::game {

class Keepaway {
  public:
    /// Places robots and ball. The scene holds config.keepers + config.takers players.
    Keepaway(const KeepawayConfig& config, std::uint64_t seed, body::Scene& scene);

    GameState& state() { return state_; }
    const GameState& state() const { return state_; }

    /// Before the physics step: until PlayOn the ball stays where it was put.
    void before_step(body::Scene& scene);
    /// After it: end rules, counters, clock.
    void after_step(body::Scene& scene);

    /// Ends the episode from outside the rules (physics or agents failed).
    void abort(episode::Status status, const std::string& reason);

    /// Side of the area now, m.
    double side() const;
    bool over() const { return state_.mode == PlayMode::GameOver; }
    /// Without state hash and code version, which the caller knows.
    episode::Result result() const;

  private:
    void place_everybody(body::Scene& scene);
    void return_strayed(body::Scene& scene);
    void count(const body::Scene& scene);
    std::optional<std::string> broken_rule(const body::Scene& scene) const;
    void end(episode::Status status, const std::string& reason);

    KeepawayConfig config_;
    std::uint64_t seed_;
    Start start_;
    GameState state_;
    PassCounter passes_;
    PlayerLog log_;
    episode::Status status_ = episode::Status::Finished;
    std::string reason_;
};

}  // namespace k3d::server::game
