// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/report/run_progress.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>

namespace k3d::optimizer::report {

namespace {

constexpr const char* kWipe = "\r\x1b[K";
constexpr std::chrono::milliseconds kOnTerminal{200};
constexpr std::chrono::seconds kElsewhere{30};
/// Beyond this many generations the limit is none, and no end can be told.
constexpr int kManyGenerations = 100000;

std::string duration(double seconds) {
    const auto minutes = static_cast<long>(std::ceil(seconds / 60.0));
    if (minutes < 60) return fmt::format("{} min", minutes);
    return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

}  // namespace

void RunProgress::wipe() {
    if (line_open_) out_ << kWipe << std::flush;
    line_open_ = false;
}

void RunProgress::say(const std::string& text) {
    wipe();
    out_ << text << '\n' << std::flush;
}

void RunProgress::begin(const std::string& text) {
    say(text);
    stage_ = {};
}

double RunProgress::Tally::wall_s() const {
    return std::max(1e-3, std::chrono::duration<double>(Clock::now() - start).count());
}

std::string RunProgress::Tally::rates() const {
    return fmt::format("{:.1f} episodes per min, {:.1f} simulated s per wall s{}",
                       static_cast<double>(episodes) * 60.0 / wall_s(), simulated_s / wall_s(),
                       failed > 0 ? fmt::format(", {} failed", failed) : "");
}

std::string RunProgress::rates() const {
    return stage_.rates();
}

std::string RunProgress::summary() const {
    return all_.rates();
}

std::string RunProgress::overhead() const {
    struct rusage used {};
    ::getrusage(RUSAGE_SELF, &used);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) * 1e-6;
    };
    return fmt::format("the daemon itself worked {:.2f} % of the episodes' time",
                       100.0 * (seconds(used.ru_utime) + seconds(used.ru_stime)) /
                           std::max(wall_s_, 1e-3));
}

std::string RunProgress::eta(const RunView& view) const {
    const bool endless = !view.test && view.max_generations > kManyGenerations;
    if (stage_.episodes == 0 || endless) return "";
    const auto rounds = view.test ? 0 : view.max_generations - view.generation - 1;
    const double left = static_cast<double>(view.episodes - view.known) +
                        static_cast<double>(view.episodes) * std::max(0, rounds);
    return ", ends in " + duration(left * stage_.wall_s() / static_cast<double>(stage_.episodes));
}

void RunProgress::show(const RunView& view, const std::vector<ledger::Row>& news,
                       const std::string& backend) {
    if (view.test != in_test_) stage_ = {};
    in_test_ = view.test;
    for (const ledger::Row& row : news) {
        for (Tally* tally : {&all_, &stage_}) {
            ++tally->episodes;
            tally->failed += row.status == "failed";
            tally->simulated_s += row.simulated_s;
        }
        wall_s_ += row.wall_s;
    }
    const auto now = Clock::now();
    if (now < shown_ + (terminal_ ? Clock::duration(kOnTerminal) : Clock::duration(kElsewhere))) {
        return;
    }
    shown_ = now;
    const std::string what = view.test ? "test" : fmt::format("generation {}", view.generation);
    const std::string text = fmt::format("{}: {} of {} episodes, {}, {}{}", what, view.known,
                                         view.episodes, backend, rates(), eta(view));
    if (!terminal_) return say(text);
    out_ << kWipe << text << std::flush;
    line_open_ = true;
}

void RunProgress::closed(const nlohmann::json& line) {
    std::string text;
    for (const auto& [name, value] : line.items()) {
        if (name == "generation" || value.is_structured()) continue;
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name,
                            value.is_number_float() ? fmt::format("{:.4g}", value.get<double>())
                                                    : value.dump());
    }
    say(fmt::format("generation {}: {}", line.value("generation", 0), text));
}

}  // namespace k3d::optimizer::report
