// SPDX-License-Identifier: BSD-3-Clause
// Keeper, taker or drill, playing or waiting.
#include "agent/decision/player.h"

#include "agent/skills/look.h"

namespace k3d::agent::decision {

Player::Player(const PlayerSettings& s, const skills::KickGeometry& kick)
    : role_(s.role),
      skills_(s.keeper.skills),
      keeper_(s.keeper, load_policy(s.keeper.keeper.policy), kick,
              RandomStream(s.seed, s.entity, "target")),
      taker_(s.taker, s.keeper.skills, RandomStream(s.seed, s.entity, "follow")),
      drill_(s.drill, s.keeper.possession, s.keeper.skills, kick,
             RandomStream(s.seed, s.entity, "drill")),
      soccer_(s.keeper.possession, s.keeper.skills, kick,
              RandomStream(s.seed, s.entity, "possession")) {}

Decision Player::decide(const world::Beliefs& b, const motion::State& body,
                        std::span<const talk::Report> reports) {
    const bool paused = b.game.play_mode == "BeforeKickOff" || b.game.play_mode == "GameOver" ||
                        b.game.play_mode.starts_with("Goal_");
    if (role_ == "soccer" && !paused && b.game.side != wire::Side::None)
        return soccer_.decide(b, body);
    const bool keeps = role_ == "keeper" || (role_ == "auto" && b.game.side == wire::Side::Left);
    const bool plays = b.game.play_mode == "PlayOn" && b.game.side != wire::Side::None;
    if (plays && role_ == "drill") return drill_.decide(b, body);
    if (plays) {
        played_ = true;
        return keeps ? keeper_.decide(b, body, reports) : taker_.decide(b, body);
    }
    if (played_ && b.game.play_mode == "BeforeKickOff") {
        played_ = false;
        keeper_.forget();
        taker_.forget();
    }
    Decision d;
    d.request.head = skills::look(b, body, false, skills_);
    d.account.role = "idle";
    d.account.skill = "wait";
    return d;
}

}  // namespace k3d::agent::decision
