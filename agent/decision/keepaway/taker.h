// SPDX-License-Identifier: BSD-3-Clause
// A taker (paper 5.2): GREEDY, all go to the ball; GREEDY+RANDOM, the closest to the ball chases
// it and each other follows a random keeper other than K1, drawn anew only when a pass is made.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "agent/decision/config.h"
#include "agent/decision/decision.h"
#include "agent/skills/config.h"
#include "agent/skills/go_to.h"
#include "agent/world/beliefs.h"
#include "common/random/stream.h"

namespace k3d::agent::decision {

/// A taker's view of who K1 is: the keeper nearest to the ball's finish. A pass is made when the
/// finish has moved by pass_distance and another keeper has been the nearest by pass_margin for
/// pass_delay.
class PassWatch {
  public:
    /// True in the cycle in which a pass is noticed, and when the first K1 is found.
    bool update(const world::Beliefs& beliefs, const TakerConfig& config);
    int k1() const { return k1_; }  ///< unum, 0 = unknown

  private:
    int k1_ = 0;
    Vec2 finish_ = Vec2::Zero();        ///< of the ball when K1 was last near it
    std::optional<double> rival_since_;
};

class Taker {
  public:
    /// `choices` draws the keepers to follow.
    Taker(const TakerConfig& config, const skills::SkillConfig& skills,
          RandomStream choices);

    Decision decide(const world::Beliefs& beliefs, const motion::State& body);

    /// Who is followed, who chases and who has the ball is not known yet: a new match.
    void forget();

    int followed() const { return followed_; }  ///< unum of the keeper, 0 = none

  private:
    bool is_chaser(const world::Beliefs& beliefs);
    void pick(const world::Beliefs& beliefs);
    motion::BodyRequest follow(const world::Beliefs& beliefs, Account& account);

    bool greedy_;  ///< strategy greedy, else greedy_random
    TakerConfig config_;
    skills::SkillConfig skills_;
    RandomStream choices_;
    PassWatch watch_;
    skills::GoTo go_to_;
    std::vector<skills::Obstacle> robots_;  ///< of this cycle; kept for its memory
    int followed_ = 0;
    int chaser_ = 0;  ///< unum of the taker nearest to the ball, of all takers
};

}  // namespace k3d::agent::decision
