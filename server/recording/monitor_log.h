// SPDX-License-Identifier: BSD-3-Clause
// A match as a file that monitors play: one frame a line (reference 2.4), full ones at the start, at
// every change of structure and from time to time, differences in between.
#pragma once

#include <fstream>
#include <string>

#include "common/clock/clock.h"
#include "server/config.h"
#include "server/monitor/frames.h"

namespace k3d::server::recording {

class MonitorLog {
  public:
    /// Starts the file anew. Throws std::runtime_error naming it if it cannot be written.
    MonitorLog(const std::string& file, const MonitorConfig& config);

    /// Whether a frame is due in this cycle.
    bool due(Cycle now) const;
    /// Appends a frame; the line is out when this returns, so a killed server leaves whole lines.
    void add(Cycle now, const monitor::SceneGraph& graph, const monitor::GameView& view);

  private:
    std::string name_;
    std::ofstream file_;
    std::int64_t interval_;       ///< cycles
    std::int64_t full_interval_;  ///< cycles
    std::int64_t last_full_;
    bool failed_ = false;
    monitor::Frames frames_;
};

}  // namespace k3d::server::recording
