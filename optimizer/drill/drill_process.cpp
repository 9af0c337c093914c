// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/drill/drill_process.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "common/config/command_line.h"
#include "optimizer/episode/collect.h"
#include "optimizer/episode/job_match.h"
#include "optimizer/spec/words.h"

namespace k3d::optimizer::drill {

namespace {

std::string log_of(const std::string& folder) {
    return folder + "/drill.log";
}

void add_set(std::vector<std::string>& words, const std::string& setting) {
    words.insert(words.end(), {"--set", setting});
}

episode::Ending fail(std::string reason) {
    return tl::unexpected(episode::Failure{std::move(reason), std::nullopt, std::nullopt});
}

/// Why the drill's program ended without a result.
episode::Failure failure_of(const process::Exit& exit, const std::string& folder) {
    episode::Failure failure{episode::describe_end("drill", exit, log_of(folder)), {}, {}};
    if (exit.signalled) return failure;
    if (exit.code == config::kExitUsage) failure.hopeless = config::kExitUsage;
    failure.of_machine = exit.code == kExitCannotStart;
    return failure;
}

/// The one line of the results, checked.
episode::Ending read(const episode::Job& job, const std::string& folder) {
    std::ifstream in(episode::result_file(folder));
    std::string line;
    if (!std::getline(in, line)) return fail("the drill has left no result");
    try {
        const episode::Result result = k3d::episode::from_line(line);
        const std::string game = "drill_" + std::string(spec::drill_of(job.task.name));
        if (result.game != game || result.seed != job.seed) {
            return fail(fmt::format("the result is of game '{}', seed {}", result.game,
                                    result.seed));
        }
        if (result.status != k3d::episode::Status::Finished &&
            result.status != k3d::episode::Status::Truncated) {
            return fail(fmt::format("{}: {}", k3d::episode::name(result.status), result.reason));
        }
        return result;
    } catch (const k3d::episode::ResultError& error) {
        return fail(error.what());
    }
}

}  // namespace

std::vector<std::string> drill_command(const episode::Job& job, const std::string& folder) {
    // Run k of a drill has seed + k and row k of its table, if it has one: of one run both are
    // chosen here.
    const int row = job.key.episode % spec::kKickScenarios;
    const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
    const std::string pool(episode::name_of(job.key.phase));
    std::vector<std::string> words{
        self, "drill", std::string(spec::drill_of(job.task.name)),
        "--runs", "1", "--seed", std::to_string(job.seed - static_cast<std::uint64_t>(row)),
        "--scenarios", pool == "baseline" ? "test" : pool,
        "--results", episode::result_file(folder),
        "--log-folder", folder};
    add_set(words, fmt::format("first={}", row));
    for (const std::string& text : spec::split_words(job.task.drill)) add_set(words, text);
    if (!job.task.server_program.empty()) add_set(words, "server_program=" + job.task.server_program);
    if (!job.task.agent_program.empty()) add_set(words, "agent_program=" + job.task.agent_program);
    for (const std::string& setting : spec::split_words(job.task.settings)) add_set(words, setting);
    // Not for the second robot of a drill: the candidate would set the task that it is judged on.
    for (const std::string& setting : episode::settings_of(job, folder)) {
        add_set(words, "keeper:" + setting);
    }
    return words;
}

DrillProcess::DrillProcess(const episode::Job& job, const std::string& folder)
    : job_(job),
      folder_(folder),
      started_(episode::Clock::now()),
      child_({drill_command(job, folder), log_of(folder), false}) {}

std::optional<episode::Ending> DrillProcess::poll() {
    if (const auto exit = child_.poll()) {
        if (exit->code == 0) return read(job_, folder_);
        return tl::unexpected(failure_of(*exit, folder_));
    }
    const std::chrono::duration<double> taken = episode::Clock::now() - started_;
    if (taken.count() < job_.task.deadline_s) return std::nullopt;
    child_.kill();
    return fail(fmt::format("no end after {} s", job_.task.deadline_s));
}

episode::Clock::time_point DrillProcess::next_look() const {
    return started_ + std::chrono::duration_cast<episode::Clock::duration>(
                          std::chrono::duration<double>(job_.task.deadline_s));
}

}  // namespace k3d::optimizer::drill
