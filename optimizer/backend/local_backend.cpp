// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/backend/local_backend.h"

#include <fmt/format.h>

namespace k3d::optimizer::backend {

void LocalBackend::fill() {
    while (pool_.room() > 0 && !waiting_.empty()) {
        pool_.start(waiting_.front());
        waiting_.pop_front();
    }
}

std::vector<episode::Outcome> LocalBackend::poll() {
    std::vector<episode::Outcome> ended = pool_.poll();
    // A start that fails must not take results with it: next_look() asks for another call at once.
    if (ended.empty()) fill();
    return ended;
}

episode::Clock::time_point LocalBackend::next_look() const {
    if (pool_.room() > 0 && !waiting_.empty()) return episode::Clock::now();
    return pool_.next_look();
}

std::string LocalBackend::state() const {
    return fmt::format("{} running", pool_.running());
}

}  // namespace k3d::optimizer::backend
