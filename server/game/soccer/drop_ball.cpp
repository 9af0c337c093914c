// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/soccer/drop_ball.h"

#include "server/game/clearing.h"
#include "server/game/soccer/kick_taker.h"

namespace k3d::server::game {

void drop_ball(Match& match, const Vec3& spot) {
    match.place_ball(spot);
    settle_ball(match.scene);
    clear_ball(match.scene);
    forget_kicks(match);
    match.enter(PlayMode::PlayOn);
}

}  // namespace k3d::server::game
