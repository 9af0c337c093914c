// SPDX-License-Identifier: BSD-3-Clause
// Simple soccer: of those it sees, the team-mate nearest to the ball goes to it and kicks it towards the
// opponents' goal; the others keep the formation.
#pragma once

#include <optional>
#include <vector>

#include "agent/decision/decision.h"
#include "agent/decision/possession.h"
#include "agent/skills/config.h"
#include "agent/skills/go_to.h"
#include "agent/world/beliefs.h"

namespace k3d::agent::decision {

/// A set play of the other team: the ball is not ours to touch.
bool is_theirs(const std::string& play_mode, wire::Side own);

class SoccerPlayer {
  public:
    /// Throws network::NetworkError. `chances`: see make_possession().
    SoccerPlayer(const PossessionConfig& possession, const skills::SkillConfig& skills,
                 const skills::KickGeometry& kick, RandomStream chances);

    Decision decide(const world::Beliefs& beliefs, const motion::State& body);

  private:
    motion::BodyRequest act(const world::Beliefs& b, const motion::State& body, Account& account);
    bool is_striker(const world::Beliefs& b);
    motion::BodyRequest strike(const world::Beliefs& b, const motion::State& body, bool committed,
                               Account& account);
    motion::BodyRequest keep_place(const world::Beliefs& b, Account& account);

    skills::SkillConfig skills_;
    PossessionBehaviour possession_;
    skills::GoTo go_to_;
    std::optional<motion::Kick> swing_;  ///< the kick asked for last or under way
    std::vector<skills::Obstacle> robots_;  ///< all others, gathered for each decision
    bool striker_ = false;
};

}  // namespace k3d::agent::decision
