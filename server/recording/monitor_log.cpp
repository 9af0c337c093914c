// SPDX-License-Identifier: BSD-3-Clause
#include "server/recording/monitor_log.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "common/log/log.h"

namespace k3d::server::recording {

namespace {
std::int64_t cycles(double seconds) { return std::llround(seconds / kCycleSeconds); }
}  // namespace

MonitorLog::MonitorLog(const std::string& file, const MonitorConfig& config)
    : name_(file),
      file_(file, std::ios::binary | std::ios::trunc),
      interval_(cycles(config.log_interval)),
      full_interval_(cycles(config.log_full_interval)),
      last_full_(-full_interval_) {
    if (!file_) {
        throw std::runtime_error("cannot write monitor log " + file + ": " + std::strerror(errno));
    }
}

bool MonitorLog::due(Cycle now) const { return !failed_ && now.count % interval_ == 0; }

void MonitorLog::add(Cycle now, const monitor::SceneGraph& graph, const monitor::GameView& view) {
    const bool other_structure = frames_.restart(graph, view);
    const bool full = other_structure || now.count - last_full_ >= full_interval_;
    if (full) last_full_ = now.count;
    file_ << (full ? frames_.full(graph, view) : frames_.difference(graph, view)) << '\n'
          << std::flush;
    if (file_) return;
    failed_ = true;  // a full disk must not end the match
    spdlog::error("cannot write to monitor log {}: it ends at {:.2f} s", name_, now.seconds());
}

}  // namespace k3d::server::recording
