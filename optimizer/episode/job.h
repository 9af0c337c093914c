// SPDX-License-Identifier: BSD-3-Clause
// One episode of an experiment as a worker anywhere gets it: everything that its result follows
// from, and nothing that is only on the daemon's machine.
#pragma once

#include <compare>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "optimizer/episode/task.h"
#include "optimizer/spec/task_spec.h"

namespace k3d::optimizer::episode {

/// What an episode is played for. The baseline meets the same seeds as the champion in its test.
enum class Phase { Train, Validation, Test, Baseline };

std::string_view name_of(Phase phase);
/// Of a champion or of the baseline: played with the settings of the test.
constexpr bool is_test(Phase phase) {
    return phase == Phase::Test || phase == Phase::Baseline;
}
/// Throws JobError naming another word.
Phase phase_of(std::string_view name);

/// The place of an episode in its run; a ledger has at most one row for each.
struct Key {
    Phase phase = Phase::Train;
    int generation = 0;  ///< in training; else 0, since the seeds are always the same
    std::uint64_t candidate = 0;
    int episode = 0;
    auto operator<=>(const Key&) const = default;
    std::string text() const;  ///< "train/3/17/0"
};

struct Job {
    std::string run;
    Key key;
    std::uint64_t seed = 0;
    int attempt = 1;  ///< of this episode, counted by the daemon
    spec::TaskSpec task;
    std::vector<std::string> settings;  ///< "path=value" of the candidate
    std::string network_path;           ///< setting that takes the network's file; empty: none
    std::string network;                ///< text of that file
    std::string code_version;           ///< of the daemon; a worker of another one must not play it
    bool operator==(const Job&) const = default;
};

/// A job or its result that cannot be read; the text names what is wrong.
class JobError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// 16 hex digits over all that the result follows from but the seed.
std::string fingerprint(const Job& job);

std::string to_json(const Job& job);
Job job_from_json(std::string_view json);  ///< throws JobError

/// How a try of a job ended, on its way back.
struct Outcome {
    Key key;
    std::uint64_t seed = 0;
    int attempt = 1;
    std::string fingerprint;  ///< of the job
    Ending ending;
    double wall_s = 0.0;
    std::string worker;  ///< host and process
};

std::string to_json(const std::string& run, const Outcome& outcome);
Outcome outcome_from_json(std::string_view json);  ///< throws JobError

}  // namespace k3d::optimizer::episode
