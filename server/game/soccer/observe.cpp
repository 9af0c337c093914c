// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/soccer/observe.h"

#include <cmath>

#include "common/clock/clock.h"

namespace k3d::server::game {

bool on_field(const Vec3& ball) {
    constexpr double kMargin = field::kBallRadius + 0.001;
    return std::abs(ball.x()) < field::kLength / 2.0 + kMargin &&
           std::abs(ball.y()) < field::kWidth / 2.0 + kMargin;
}

void observe(Match& match) {
    Memory& memory = match.memory;
    memory.now += kCycleSeconds;
    const Vec3 ball = match.scene.ball.position();
    if (match.state.mode != memory.mode) {
        match.enter(match.state.mode);
        memory.kick_spot = {ball.x(), ball.y(), field::kBallRadius};
    }
    memory.touching.clear();
    for (const int id : ball_touchers(match.scene.world.contacts())) {
        const body::Player* player = match.scene.find(id);
        if (player == nullptr || player->team == wire::Side::None) continue;
        memory.touching.push_back({player->team, player->unum, memory.now});
    }
    if (!memory.touching.empty()) memory.last_touch = memory.touching.front();
    if (on_field(ball)) memory.last_ball_on_field = ball;
}

void remember(Match& match) { match.memory.ball_before = match.scene.ball.position(); }

}  // namespace k3d::server::game
