// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/episode/job.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <array>
#include <nlohmann/json.hpp>

#include "common/config/config.h"

namespace k3d::optimizer::episode {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr std::array<std::string_view, 4> kPhases{"train", "validation", "test", "baseline"};

Json key_json(const Key& key) {
    return {{"phase", name_of(key.phase)},
            {"generation", key.generation},
            {"candidate", key.candidate},
            {"episode", key.episode}};
}

Key key_of(const Json& j) {
    return {phase_of(j.at("phase").get<std::string>()), j.at("generation").get<int>(),
            j.at("candidate").get<std::uint64_t>(), j.at("episode").get<int>()};
}

/// Values alone: what is said of a field must not make another job of it.
std::string task_text(const spec::TaskSpec& task) {
    spec::TaskSpec copy = task;
    return config::print(config::describing(copy), config::Comments::No);
}

/// Parses and reads; whatever is wrong becomes a JobError.
template <class Read>
auto reading(const char* what, std::string_view text, const Read& read) {
    try {
        const Json j = Json::parse(text);
        const int version = j.at("version").get<int>();
        if (version != kVersion) {
            throw JobError(fmt::format("{}: version {}, this program reads {}", what, version,
                                       kVersion));
        }
        return read(j);
    } catch (const nlohmann::json::exception& error) {
        throw JobError(fmt::format("{}: {}", what, error.what()));
    } catch (const config::ConfigError& error) {
        throw JobError(fmt::format("{}: {}", what, error.what()));
    } catch (const k3d::episode::ResultError& error) {
        throw JobError(fmt::format("{}: {}", what, error.what()));
    }
}

}  // namespace

std::string_view name_of(Phase phase) {
    return kPhases[static_cast<std::size_t>(phase)];
}

Phase phase_of(std::string_view name) {
    for (std::size_t i = 0; i < kPhases.size(); ++i) {
        if (kPhases[i] == name) return static_cast<Phase>(i);
    }
    throw JobError(fmt::format("phase '{}' is none of train, validation, test, baseline", name));
}

std::string Key::text() const {
    return fmt::format("{}/{}/{}/{}", name_of(phase), generation, candidate, episode);
}

std::string fingerprint(const Job& job) {
    std::string all = task_text(job.task) + '\0' + job.network_path + '\0' + job.network + '\0' +
                      job.code_version;
    for (const std::string& setting : job.settings) all += '\0' + setting;
    return fmt::format("{:016x}", XXH3_64bits(all.data(), all.size()));
}

std::string to_json(const Job& job) {
    const Json j{{"version", kVersion},
                 {"run", job.run},
                 {"key", key_json(job.key)},
                 {"seed", job.seed},
                 {"attempt", job.attempt},
                 {"task", task_text(job.task)},
                 {"settings", job.settings},
                 {"network_path", job.network_path},
                 {"network", job.network},
                 {"code_version", job.code_version}};
    return j.dump();
}

Job job_from_json(std::string_view json) {
    return reading("job", json, [](const Json& j) {
        Job job;
        job.run = j.at("run").get<std::string>();
        job.key = key_of(j.at("key"));
        job.seed = j.at("seed").get<std::uint64_t>();
        job.attempt = j.at("attempt").get<int>();
        config::load_text(config::describing(job.task), j.at("task").get<std::string>(), "task");
        job.settings = j.at("settings").get<std::vector<std::string>>();
        job.network_path = j.at("network_path").get<std::string>();
        job.network = j.at("network").get<std::string>();
        job.code_version = j.at("code_version").get<std::string>();
        return job;
    });
}

std::string to_json(const std::string& run, const Outcome& outcome) {
    Json j{{"version", kVersion},
           {"run", run},
           {"key", key_json(outcome.key)},
           {"seed", outcome.seed},
           {"attempt", outcome.attempt},
           {"fingerprint", outcome.fingerprint},
           {"wall_s", outcome.wall_s},
           {"worker", outcome.worker}};
    if (outcome.ending) {
        j["result"] = k3d::episode::to_line(*outcome.ending);
    } else {
        j["failure"] = outcome.ending.error().reason;
        if (outcome.ending.error().hopeless) j["hopeless"] = *outcome.ending.error().hopeless;
    }
    // What a program printed may be no UTF-8.
    return j.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Outcome outcome_from_json(std::string_view json) {
    return reading("outcome", json, [](const Json& j) {
        Outcome outcome;
        outcome.key = key_of(j.at("key"));
        outcome.seed = j.at("seed").get<std::uint64_t>();
        outcome.attempt = j.at("attempt").get<int>();
        outcome.fingerprint = j.at("fingerprint").get<std::string>();
        outcome.wall_s = j.at("wall_s").get<double>();
        outcome.worker = j.at("worker").get<std::string>();
        if (j.contains("result")) {
            outcome.ending = k3d::episode::from_line(j.at("result").get<std::string>());
            return outcome;
        }
        Failure failure{j.at("failure").get<std::string>(), std::nullopt, std::nullopt};
        if (j.contains("hopeless")) failure.hopeless = j.at("hopeless").get<int>();
        outcome.ending = tl::unexpected(failure);
        return outcome;
    });
}

}  // namespace k3d::optimizer::episode
