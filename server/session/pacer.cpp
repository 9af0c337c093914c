// SPDX-License-Identifier: BSD-3-Clause
#include "server/session/pacer.h"

#include <algorithm>
#include <chrono>

namespace k3d::server::session {

namespace {
constexpr std::chrono::milliseconds kCycle{20};
}

Pacer::Pacer(const PaceConfig& config)
    : waits_for_agents_(config.mode != "realtime"),
      has_clock_(config.mode != "fast"),
      patience_(std::chrono::duration_cast<net::Clock::duration>(
          std::chrono::duration<double>(config.hung_agent))),
      next_(net::Clock::now()) {}

void Pacer::wait_for_clock(net::Loop& loop) {
    if (has_clock_) {
        loop.wait(next_, [] { return false; });
        next_ = std::max(next_ + kCycle, net::Clock::now());
    }
    loop.poll();
}

bool Pacer::wait_for_agents(net::Loop& loop, const std::function<bool()>& all_synced) const {
    return loop.wait(net::Clock::now() + patience_, all_synced);
}

}  // namespace k3d::server::session
