// SPDX-License-Identifier: BSD-3-Clause
// When the next cycle may begin: by the wall clock, by the agents, or both (design: pace).
#pragma once

#include <functional>

#include "common/net/net.h"
#include "server/config.h"

namespace k3d::server::session {

class Pacer {
  public:
    explicit Pacer(const PaceConfig& config);

    bool waits_for_agents() const { return waits_for_agents_; }

    /// Returns when the cycle may begin; sockets are served meanwhile. In realtime and sync a cycle
    /// begins 20 ms after the one before; time lost is not caught up (reference 2.2).
    void wait_for_clock(net::Loop& loop);

    /// Serves sockets until `all_synced` holds; false when the deadline for hung agents passed.
    bool wait_for_agents(net::Loop& loop, const std::function<bool()>& all_synced) const;

  private:
    bool waits_for_agents_;
    bool has_clock_;
    net::Clock::duration patience_;
    net::Clock::time_point next_;
};

}  // namespace k3d::server::session
