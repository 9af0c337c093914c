// SPDX-License-Identifier: BSD-3-Clause
// Where a cycle's processor time goes: one reading of the thread's CPU clock at each border between
// stages, and none at all while it is off.
#pragma once

#include <ctime>

#include <array>
#include <cstddef>
#include <string_view>

namespace k3d {

enum class Stage { Wire, Rules, Collision, Physics, Percepts, Shown };
inline constexpr std::array<std::string_view, 6> kStageNames{"wire",    "rules",    "collision",
                                                             "physics", "percepts", "shown"};

class StageClock {
  public:
    explicit StageClock(bool on) : on_(on) {}

    bool on() const { return on_; }
    /// From here on the time is this stage's.
    void enter(Stage stage) {
        if (!on_) return;
        const double now = seconds_of(CLOCK_THREAD_CPUTIME_ID);
        if (running_) spent_[static_cast<std::size_t>(stage_)] += now - since_;
        running_ = true;
        stage_ = stage;
        since_ = now;
    }
    /// CPU seconds of a stage so far, without the one that runs.
    double spent(Stage stage) const { return spent_[static_cast<std::size_t>(stage)]; }

    /// CPU seconds of the whole process.
    static double process_seconds() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }

  private:
    static double seconds_of(clockid_t clock) {
        timespec now{};
        ::clock_gettime(clock, &now);
        return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
    }

    bool on_;
    bool running_ = false;
    Stage stage_ = Stage::Wire;
    double since_ = 0.0;
    std::array<double, kStageNames.size()> spent_{};
};

}  // namespace k3d
