// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/soccer/kick_taker.h"

namespace k3d::server::game {

void note_kick(Match& match, bool indirect) {
    match.memory.kicker = match.memory.last_touch;
    match.memory.indirect = indirect;
}

void forget_kicks(Match& match) {
    match.memory.kicker.reset();
    match.memory.indirect = false;
    match.memory.barred = wire::Side::None;
    for (PassUse& use : match.memory.passes) use.last.reset();
}

bool straight_from_kick(const Match& match) {
    const auto& kicker = match.memory.kicker;
    const auto& last = match.memory.last_touch;
    return kicker && last && last->same_player(*kicker) && last->time - kicker->time < kKickDuration;
}

bool kicker_touched_twice(Match& match) {
    if (!match.memory.kicker || straight_from_kick(match)) return false;
    const Touch kicker = *match.memory.kicker;
    const Touch last = *match.memory.last_touch;
    match.memory.kicker.reset();
    match.memory.indirect = false;
    if (!last.same_player(kicker)) return false;
    const Vec3 ball = match.memory.last_ball_on_field;
    match.memory.kick_spot = {ball.x(), ball.y(), field::kBallRadius};
    match.enter(mode_for(PlayMode::FreeKickLeft, opponent(kicker.team)));
    return true;
}

}  // namespace k3d::server::game
