// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/state.h"

#include <algorithm>

#include "common/clock/clock.h"

namespace k3d::server::game {

void GameState::advance() {
    mode_time += kCycleSeconds;
    if (mode != PlayMode::BeforeKickOff && mode != PlayMode::GameOver) time += kCycleSeconds;
}

std::vector<int> ball_touchers(std::span<const physics::Contact> contacts) {
    std::vector<int> ids;
    for (const physics::Contact& contact : contacts) {
        if (contact.a->kind != physics::Kind::Robot || contact.b->kind != physics::Kind::Ball) {
            continue;
        }
        if (std::find(ids.begin(), ids.end(), contact.a->owner) == ids.end()) {
            ids.push_back(contact.a->owner);
        }
    }
    return ids;
}

}  // namespace k3d::server::game
