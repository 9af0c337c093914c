// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/report/progress.h"

#include <fmt/format.h>

#include <algorithm>

namespace k3d::optimizer::report {

namespace {

constexpr const char* kWipe = "\r\x1b[K";

const char* plural(int count) {
    return count == 1 ? "" : "s";
}

}  // namespace

Progress::Progress(const spec::MatchSpec& spec, std::ostream& out, bool terminal)
    : spec_(spec), out_(out), terminal_(terminal) {}

void Progress::end() {
    if (line_open_) out_ << kWipe << std::flush;
    line_open_ = false;
}

void Progress::line(const std::string& text) {
    end();
    out_ << text << '\n' << std::flush;
}

void Progress::page(int port) {
    if (!page_shown_) line(fmt::format("page: http://127.0.0.1:{}/", port));
    page_shown_ = true;
}

void Progress::done(const backend::Finished& finished) {
    const episode::Result& result = *finished.ending;
    simulated_s_ += result.hold_time_s;
    if (terminal_) return;
    const int passes = result.passes_completed;
    line(
        fmt::format("episode {}/{} seed {}: {} after {:.2f} s, {} kick{}, {} pass{} "
                    "({:.1f} simulated s per wall s)",
                    finished.task.index + 1, spec_.episodes, finished.task.seed, result.reason,
                    result.hold_time_s, result.kicks, plural(result.kicks), passes,
                    passes == 1 ? "" : "es", result.hold_time_s / std::max(finished.wall_s, 1e-3)));
}

void Progress::failed(const backend::Finished& finished, bool again) {
    line(fmt::format("episode {}/{} seed {}: try {} of {} failed: {}; logs in {}{}",
                     finished.task.index + 1, spec_.episodes, finished.task.seed,
                     finished.task.attempt, spec_.retries + 1, finished.ending.error().reason,
                     finished.folder, again ? "" : "; given up"));
}

void Progress::show(const Run& run, std::size_t running) {
    if (!terminal_) return;
    double held = 0.0;
    for (const auto& [index, result] : run.results) held += result.hold_time_s;
    const std::string mean = run.results.empty()
                                 ? ""
                                 : fmt::format(", mean hold time {:.2f} s",
                                               held / static_cast<double>(run.results.size()));
    line_open_ = true;
    out_ << kWipe
         << fmt::format("{}/{} episodes, {} running{}, {:.1f} simulated s per wall s",
                        run.settled(), spec_.episodes, running, mean, simulated_per_second())
         << std::flush;
}

double Progress::simulated_per_second() const {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start_;
    return simulated_s_ / std::max(wall.count(), 1e-3);
}

}  // namespace k3d::optimizer::report
