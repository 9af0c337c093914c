// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/report/table.h"

#include <fmt/format.h>

#include <functional>
#include <vector>

#include "optimizer/report/statistics.h"

namespace k3d::optimizer::report {

namespace {

using episode::Result;
using Figure = std::function<std::optional<double>(const Result&)>;

constexpr double kMinute = 60.0;  // s

std::string cell(const std::optional<double>& value) {
    return value ? fmt::format("{:9.2f}", *value) : fmt::format("{:>9}", "-");
}

/// Episodes that do not have the figure are left out, and n tells.
std::string row(const char* name, const Run& run, const Figure& figure) {
    std::vector<double> sample;
    for (const auto& [index, result] : run.results) {
        if (const auto value = figure(result)) sample.push_back(*value);
    }
    const Statistics s = statistics(sample);
    return fmt::format("{:<14}{:>6}{}{}{}\n", name, s.n, cell(s.mean), cell(s.sd), cell(s.se));
}

std::string heading(const spec::MatchSpec& spec) {
    const auto side = [](const std::string& command, const std::string& own) {
        if (!command.empty()) return " (" + command + ")";
        return own.empty() ? own : " (" + own + ")";
    };
    return fmt::format("{} keepers{} against {} takers{}, {} pace, seeds {} to {}\n", spec.keepers,
                       side(spec.keeper_command, spec.keeper_policy), spec.takers,
                       side(spec.taker_command, spec.taker), spec.pace, spec.seed,
                       spec.seed + static_cast<std::uint64_t>(spec.episodes) - 1);
}

/// "taker_reached_ball 16, ball_out 3, time_limit 1 (truncated)"
std::string ends(const Run& run) {
    std::map<std::string, int> counts;
    for (const auto& [index, result] : run.results) {
        const bool truncated = result.status == k3d::episode::Status::Truncated;
        ++counts[result.reason + (truncated ? " (truncated)" : "")];
    }
    std::string text;
    for (const auto& [reason, count] : counts) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", reason, count);
    }
    return text.empty() ? "-" : text;
}

/// Of one side ("left", "right"), or of both ("").
std::optional<double> falls_per_minute(const Run& run, std::string_view team) {
    double falls = 0.0;
    double minutes = 0.0;  // of all players
    for (const auto& [index, result] : run.results) {
        for (const auto& player : result.players) {
            if (!team.empty() && player.team != team) continue;
            falls += player.falls;
            minutes += result.hold_time_s / kMinute;
        }
    }
    return minutes > 0.0 ? std::optional(falls / minutes) : std::nullopt;
}

std::string number(const std::optional<double>& value) {
    return value ? fmt::format("{:.2f}", *value) : "-";
}

std::string received(const Run& run) {
    int kicks = 0;
    int passes = 0;
    for (const auto& [index, result] : run.results) {
        kicks += result.kicks;
        passes += result.passes_completed;
    }
    if (kicks == 0) return "- (no kicks)";
    return fmt::format("{:.1f} % ({} of {})", 100.0 * passes / kicks, passes, kicks);
}

std::string failures(const spec::MatchSpec& spec, const Run& run) {
    std::string text;
    for (const auto& [index, failure] : run.failures) {
        text += fmt::format("  episode {}, seed {}: {}\n", index + 1,
                            spec.seed + static_cast<std::uint64_t>(index), failure.reason);
    }
    return text;
}

}  // namespace

std::string table(const spec::MatchSpec& spec, const Run& run) {
    std::string text = heading(spec);
    text += fmt::format("{:<14}{:>6}{:>9}{:>9}{:>9}\n", "", "n", "mean", "sd", "se");
    text += row("hold time, s", run, [](const Result& r) { return r.hold_time_s; });
    text += row("attempts", run, [](const Result& r) -> std::optional<double> {
        return r.attempts ? std::optional<double>(*r.attempts) : std::nullopt;
    });
    text += row("kicks", run, [](const Result& r) { return r.kicks; });
    text += row("passes", run, [](const Result& r) { return r.passes_completed; });
    text += "ended by: " + ends(run) + "\n";
    text += "kicks received by another keeper: " + received(run) + "\n";
    text += fmt::format("falls per player and minute: {} (keepers {}, takers {})\n",
                        number(falls_per_minute(run, "")), number(falls_per_minute(run, "left")),
                        number(falls_per_minute(run, "right")));
    if (!run.failures.empty() || run.interrupted) {
        text += fmt::format("episodes with a valid result: {} of {}{}\n", run.results.size(),
                            spec.episodes, run.interrupted ? " (interrupted)" : "");
    }
    return text + failures(spec, run);
}

}  // namespace k3d::optimizer::report
