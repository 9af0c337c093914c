// SPDX-License-Identifier: BSD-3-Clause
// Each player's falls and path, from ground truth, for the episode's result.
#pragma once

#include <vector>

#include "common/episode/result.h"
#include "server/body/scene.h"

namespace k3d::server::game {

class PlayerLog {
  public:
    explicit PlayerLog(const body::Scene& scene);

    /// One cycle of PlayOn.
    void update(const body::Scene& scene);

    std::vector<episode::PlayerResult> results(double hold_time_s) const;

  private:
    struct Entry {
        int id;
        episode::PlayerResult result;
        Vec2 sampled;  ///< position at the last sample of the path
        bool down = false;
    };
    std::vector<Entry> entries_;
    int cycles_ = 0;
};

}  // namespace k3d::server::game
