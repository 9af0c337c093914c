// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/episode/collect.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <vector>

#include "optimizer/episode/telemetry.h"
#include "optimizer/spec/ask.h"

namespace k3d::optimizer::episode {

namespace {

Ending fail(std::string reason, std::optional<Result> result = {}) {
    return tl::unexpected(Failure{std::move(reason), std::move(result), {}});
}

std::vector<std::string> lines_of(const std::string& file) {
    std::ifstream in(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

bool counts(const Result& result) {
    return result.status == k3d::episode::Status::Finished ||
           result.status == k3d::episode::Status::Truncated;
}

/// Only keepers of ours write telemetry: with a foreign program their attempts are unknown.
std::optional<int> attempts_of(const spec::MatchSpec& spec, const std::string& folder) {
    if (is_foreign(spec, Seat{true})) return std::nullopt;
    int attempts = 0;
    for (const Seat& seat : seats(spec)) {
        if (seat.keeper) attempts += count_attempts(telemetry_file(folder, seat));
    }
    return attempts;
}

}  // namespace

std::string last_line(const std::string& log_file) {
    std::ostringstream text;
    text << std::ifstream(log_file).rdbuf();
    return spec::last_words(text.str());
}

std::string describe_end(const std::string& name, const process::Exit& exit,
                         const std::string& log_file) {
    const std::string said = last_line(log_file);
    return fmt::format("{}: {}{}{}", name, exit.text(), said.empty() ? "" : ": ", said);
}

Ending collect(const spec::MatchSpec& spec, const Task& task, const std::string& folder,
               const process::Exit& exit) {
    const bool lost = exit.code == kServerLostAnAgent && !exit.signalled;
    if (exit.code != 0 && !lost) {
        return fail(describe_end("server", exit, folder + "/server.log"));
    }
    const std::vector<std::string> lines = lines_of(result_file(folder));
    if (lines.size() != 1) {
        if (lost) return fail("agent_lost: " + last_line(folder + "/server.log"));
        return fail(fmt::format("{} has {} lines, not 1", result_file(folder), lines.size()));
    }
    try {
        Result result = k3d::episode::from_line(lines[0]);
        if (result.seed != task.seed || result.game != "keepaway") {
            return fail(
                fmt::format("the result is of game '{}', seed {}", result.game, result.seed));
        }
        if (!counts(result)) {
            return fail(fmt::format("{}: {}", k3d::episode::name(result.status), result.reason),
                        result);
        }
        if (lost) return fail("agent_lost: " + last_line(folder + "/server.log"), result);
        result.attempts = attempts_of(spec, folder);
        return result;
    } catch (const k3d::episode::ResultError& error) {
        return fail(error.what());
    } catch (const TelemetryError& error) {
        return fail(error.what());
    }
}

}  // namespace k3d::optimizer::episode
