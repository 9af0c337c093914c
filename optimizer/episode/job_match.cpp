// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/episode/job_match.h"

#include <fstream>
#include <stdexcept>

#include "optimizer/spec/words.h"

namespace k3d::optimizer::episode {

namespace {

std::string write_network(const Job& job, const std::string& folder) {
    const std::string path = folder + "/network.json";
    std::ofstream file(path);
    file << job.network << std::flush;
    if (!file) throw std::runtime_error("cannot write " + path);
    return path;
}

}  // namespace

std::vector<std::string> settings_of(const Job& job, const std::string& folder) {
    std::vector<std::string> settings = job.settings;
    if (!job.network_path.empty()) {
        settings.push_back(job.network_path + "=" + write_network(job, folder));
    }
    return settings;
}

spec::MatchSpec match_of(const Job& job, const std::string& folder) {
    const spec::TaskSpec& task = job.task;
    spec::MatchSpec match;
    match.seed = job.seed;
    match.keepers = task.keepers;
    match.takers = task.takers;
    match.taker = task.taker;
    match.taker_command = task.taker_command;
    match.settings = task.settings;
    for (const std::string& setting : settings_of(job, folder)) {
        match.settings += " " + spec::quote_word(task.tuned + ":" + setting);
    }
    // What is reported is played as matches are, by distinct processes.
    match.one_process = job.key.phase == Phase::Train || job.key.phase == Phase::Validation;
    match.retries = 0;
    match.deadline_s = task.deadline_s;
    match.lobby_s = task.lobby_s;
    match.hung_agent_s = task.hung_agent_s;
    match.server_program = task.server_program;
    match.agent_program = task.agent_program;
    return match;
}

}  // namespace k3d::optimizer::episode
