// SPDX-License-Identifier: BSD-3-Clause
// A robot that practises one skill alone, for those who measure it: walk, go_to, kick, getting up.
// It acts in PlayOn and knows no more than a player: the wire and its configuration.
#pragma once

#include <optional>

#include "agent/decision/decision.h"
#include "agent/decision/drill/config.h"
#include "agent/decision/possession.h"
#include "agent/skills/config.h"
#include "agent/skills/go_to.h"
#include "agent/world/beliefs.h"
#include "common/random/stream.h"

namespace k3d::agent::decision {

class Drill {
  public:
    /// `places` draws the targets of go_to. Throws network::NetworkError.
    Drill(const DrillConfig& config, const PossessionConfig& possession,
          const skills::SkillConfig& skills, const skills::KickGeometry& kick, RandomStream places);

    Decision decide(const world::Beliefs& beliefs, const motion::State& body);

  private:
    motion::BodyRequest act(const world::Beliefs& b, const motion::State& body, Account& account);
    motion::BodyRequest go_to(const world::Beliefs& b, const motion::State& body, Account& account);
    motion::BodyRequest kick(const world::Beliefs& b, const motion::State& body, Account& account);
    motion::BodyRequest fall(const motion::State& body);

    DrillConfig config_;
    skills::SkillConfig skills_;
    PossessionBehaviour possession_;
    RandomStream places_;
    skills::GoTo go_to_;
    Pose2 place_;               ///< of go_to
    double place_until_ = -1.0;
    double fall_at_ = 0.0;               ///< s, of the next fall on purpose
    int falls_ = 0;                      ///< so far, when that one is due
    std::optional<motion::Kick> swing_;  ///< the kick asked for last or under way
    bool done_ = false;                  ///< the one kick or fall is over
};

}  // namespace k3d::agent::decision
