// SPDX-License-Identifier: BSD-3-Clause
// An experiment: what is tuned, on which task, by which algorithm, for how long. One TOML file:
//
//     name = "keepaway_cmaes"
//     [task]                                # spec/task_spec.h
//     name = "keepaway"
//     [algorithm]                           # spec/algorithm_spec.h
//     name = "cmaes"
//     [parameters.keeper.hold_threshold]    # any number among the settings of k3d-agent
//     lower = 1.0
//     upper = 5.0                           # start, deviation, frozen may follow
//     [parameters.motion.kick.far.duration_s.0]    # or an element, from 0, of a list of numbers
//
// or, instead of parameters, a network whose file is the value of one setting:
//
//     [network]
//     path = "keeper.policy"
//     start = "networks/evaluation_linear.json"    # beside the experiment's file
//
// Seeds need no section: training, validation and test scenarios are drawn from pools of the run's
// `seed` that cannot overlap (algorithm/seeds.h).
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/config/config.h"
#include "common/network/network.h"
#include "optimizer/spec/agent_fields.h"
#include "optimizer/spec/algorithm_spec.h"
#include "optimizer/spec/task_spec.h"

namespace k3d::optimizer::spec {

struct BudgetSpec {
    double simulated_hours = 0.0;
    void describe(config::Fields& f) {
        f.number("simulated_hours", simulated_hours, {0.0, 1e9}, "h",
                 "of training episodes; the generation that begins after these is the last one; 0: no limit");
    }
};

struct TestSpec {
    int episodes = 100;
    bool baseline = true;
    std::string settings;
    void describe(config::Fields& f) {
        f.integer("episodes", episodes, {0, 100000}, "",
                  "of the champion on test seeds, which nothing before has seen");
        f.boolean("baseline", baseline, "play the same seeds with the task's settings alone, too");
        f.text("settings", settings, {},
               "further words as task.settings has them, in the test alone: learnt on the fast stepper, "
               "judged on the exact one");
    }
};

struct NetworkSpec {
    std::string path;
    std::string start;
    double bound = 10.0;
    double deviation = 1.0;
    void describe(config::Fields& f) {
        f.text("path", path, {}, "setting of the agent that takes the network's file");
        f.text("start", start, {}, "network file: inputs, outputs and where the search begins");
        f.number("bound", bound, {1e-6, 1e6}, "", "weights and biases stay within +- this, except neat's");
        f.number("deviation", deviation, {1e-9, 1e6}, "", "of the first weights and biases");
    }
};

struct Experiment {
    std::string name;
    std::string description;
    std::uint64_t seed = 1;
    TaskSpec task;
    AlgorithmSpec algorithm;
    BudgetSpec budget;
    TestSpec test;
    NetworkSpec network;
    VectorProblem parameters;  ///< of the agent; empty with a network
    std::map<std::string, std::vector<double>> lists;  ///< the agent's own, by path
    std::optional<network::Definition> start_network;

    void describe(config::Fields& f);
};

/// Text of a file that the experiment names; throws std::runtime_error.
using ReadFile = std::function<std::string(const std::string& name)>;

/// "path=value", each stronger than the file, e.g. algorithm.max_generations=2.
using Overrides = std::vector<std::string>;

/// Throws config::ConfigError, each fault with file and line, all at once.
Experiment parse_experiment(std::string_view toml, const std::string& file,
                            const AgentFields& fields, const ReadFile& read,
                            const Overrides& overrides = {});

/// The words of settings that episodes of the test are played with.
std::string test_settings(const Experiment& experiment);

/// What the algorithm searches.
Problem problem_of(const Experiment& experiment);

/// A candidate's values as settings of the agent: path and TOML value. A list with tuned elements is
/// one setting, its other elements are the agent's own.
std::vector<std::pair<std::string, std::string>> settings_of(const Experiment& experiment,
                                                             const std::vector<double>& values);

/// The start network with these weights and biases, in the order of problem_of().
network::Definition with_weights(const network::Definition& start,
                                 const std::vector<double>& values);

}  // namespace k3d::optimizer::spec
