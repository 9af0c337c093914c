// SPDX-License-Identifier: BSD-3-Clause
// A player's decision in one cycle: its job by side and settings, its conduct by play mode.
#pragma once

#include <span>
#include <string>

#include "agent/decision/decision.h"
#include "agent/decision/drill/drill.h"
#include "agent/decision/keepaway/keeper.h"
#include "agent/decision/keepaway/taker.h"
#include "agent/decision/soccer/soccer_player.h"

namespace k3d::agent::decision {

struct PlayerSettings {
    std::string role = "auto";  ///< auto, keeper, taker, drill, soccer
    KeeperSettings keeper;
    TakerConfig taker;
    DrillConfig drill;
    std::uint64_t seed = 1;
    std::string entity;         ///< names this player's random streams
};

class Player {
  public:
    /// Throws network::NetworkError for a policy or network that cannot be used.
    Player(const PlayerSettings& settings, const skills::KickGeometry& kick);

    /// Keeps, takes or drills while the game is on; otherwise stands and looks around. What keeper and
    /// taker remember of a match goes when the next begins.
    Decision decide(const world::Beliefs& beliefs, const motion::State& body,
                    std::span<const talk::Report> reports);

  private:
    std::string role_;
    bool played_ = false;  ///< in this match
    skills::SkillConfig skills_;
    Keeper keeper_;
    Taker taker_;
    Drill drill_;
    SoccerPlayer soccer_;
};

}  // namespace k3d::agent::decision
