// SPDX-License-Identifier: BSD-3-Clause
// Log lines that strangers can cause, at most so many a second: a log must not be a way to fill a
// disk. What is left out is counted, and the count is a line.
#pragma once

#include <chrono>
#include <utility>

#include "common/log/log.h"

namespace k3d::log {

class Limiter {
  public:
    using Clock = std::chrono::steady_clock;

    explicit Limiter(int lines_per_second = 20) : lines_per_second_(lines_per_second) {}
    ~Limiter() { report(); }
    Limiter(const Limiter&) = delete;
    Limiter& operator=(const Limiter&) = delete;

    template <class... Args>
    void say(spdlog::level::level_enum level, spdlog::format_string_t<Args...> format,
             Args&&... args) {
        if (!spdlog::should_log(level) || !allows(level, Clock::now())) return;
        spdlog::log(level, format, std::forward<Args>(args)...);
    }

    /// Counts one line, and says whether it may be written. Warnings have an allowance of their
    /// own: mere comings and goings cannot crowd them out.
    bool allows(spdlog::level::level_enum level, Clock::time_point now);
    int left_out() const { return left_out_; }

  private:
    void report();

    int lines_per_second_;
    int lines_[2] = {0, 0};  // in this second: others, warnings
    int left_out_ = 0;
    Clock::time_point second_{};
};

/// The beginning of a stranger's text, fit for a log: bytes outside printable ASCII become '?'.
std::string printable(std::string_view text);

}  // namespace k3d::log
