// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/soccer/half_time.h"

namespace k3d::server::game {

void end_half(Match& match) {
    const double time = match.state.time + kTimeSlack;
    if (match.state.half == 1 && time >= match.config.half_time) {
        match.state.half = 2;
        match.enter(PlayMode::BeforeKickOff);
    } else if (match.state.half == 2 && time >= 2.0 * match.config.half_time &&
               match.state.mode != PlayMode::GameOver) {
        match.enter(PlayMode::GameOver);
    }
}

}  // namespace k3d::server::game
