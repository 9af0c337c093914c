// SPDX-License-Identifier: BSD-3-Clause
// A keeper (paper 5.1): takes its role; K1 chooses target and helper, gets the ball, holds or
// kicks; K2 goes to the target and faces the ball; K3 goes home, or to a learned place, and watches.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "agent/decision/config.h"
#include "agent/decision/decision.h"
#include "agent/decision/keepaway/in_time.h"
#include "agent/decision/keepaway/open_place.h"
#include "agent/decision/keepaway/policy.h"
#include "agent/decision/keepaway/roles.h"
#include "agent/decision/possession.h"
#include "agent/skills/config.h"
#include "agent/skills/go_to.h"
#include "agent/talk/ears.h"
#include "agent/world/beliefs.h"
#include "common/random/stream.h"

namespace k3d::agent::decision {

/// Where keeper `unum` is born: evenly on a circle of a quarter of the side, the first at 90
/// degrees (team frame of the left team).
Vec2 birth_place(int unum, const KeepawayConfig& config);

struct KeeperSettings {
    KeepawayConfig keepaway;
    KeeperConfig keeper;
    EvaluationConfig evaluation;
    PossessionConfig possession;
    skills::SkillConfig skills;
};

class Keeper {
  public:
    /// `choices`: stream of the random policy. Throws network::NetworkError.
    Keeper(const KeeperSettings& settings, Policy policy, const skills::KickGeometry& kick,
           RandomStream choices);

    /// Decides for one cycle of play.
    Decision decide(const world::Beliefs& beliefs, const motion::State& body,
                    std::span<const talk::Report> reports);

    /// Role, home, target and swing belong to the match that is over. Allocates nothing.
    void forget();

  private:
    motion::BodyRequest act(const world::Beliefs& beliefs, const motion::State& body,
                            const Assignment& part, Account& account);
    motion::BodyRequest act_k1(const world::Beliefs& beliefs, const motion::State& body,
                               bool committed, Account& account);
    void choose_target(const world::Beliefs& beliefs, Account& account);
    /// Room of policy.h: for the stance, for where the ball lands, between that and the target, and
    /// beside takers of situation_ near by.
    double room_for(const Vec2& target, const Vec2& ball) const;
    double time_until_taker(const PassSituation& situation) const;  ///< s until one is at the ball
    /// How soon K1 at `self` can have kicked the ball, s; sooner at the present target.
    double time_to_kick(const Vec2& target, const Pose2& self, const Vec2& ball) const;
    /// Where K3 goes: home, or where the learned function sends it.
    Vec2 place_of_k3(const world::Beliefs& beliefs, const Assignment& part);
    motion::BodyRequest walk_and_watch(const world::Beliefs& beliefs, const Vec2& place);

    KeeperSettings settings_;
    Policy policy_;
    skills::KickGeometry kick_;
    RandomStream choices_;
    std::vector<Vec2> grid_;
    std::optional<OpenPlace> open_;
    RoleKeeper roles_;
    PossessionBehaviour possession_;
    skills::GoTo go_to_;
    std::optional<Vec2> home_;        ///< where this keeper was born
    std::optional<Vec2> target_;      ///< while K1
    std::optional<motion::Kick> swing_;  ///< the kick asked for last or under way
    PassSituation situation_;                  ///< of this cycle; kept for its memory
    std::vector<skills::Obstacle> obstacles_;  ///< likewise
    std::vector<Vec2> in_time_;                ///< likewise
    std::vector<Scored> scored_;               ///< likewise
    int k2_ = 0;
    bool was_k1_ = false;
};

}  // namespace k3d::agent::decision
