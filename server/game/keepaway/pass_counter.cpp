// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/keepaway/pass_counter.h"

namespace k3d::server::game {

void PassCounter::update(const std::vector<int>& keepers, const std::vector<int>& takers,
                         const Vec2& ball) {
    if (last_ && !last_->left && (ball - last_->ball).norm() >= kLeftDistance) {
        last_->left = true;
        ++kicks_;
    }
    if (!takers.empty()) last_.reset();  // whatever comes next is no pass
    for (const int id : keepers) touched_by_keeper(id, ball);
}

void PassCounter::touched_by_keeper(int id, const Vec2& ball) {
    if (last_ && last_->left && last_->keeper != id && (ball - last_->ball).norm() >= kPassDistance) {
        ++passes_;
    }
    last_ = Touch{id, ball, false};
}

}  // namespace k3d::server::game
