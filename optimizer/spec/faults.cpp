// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/spec/faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "optimizer/spec/drill_spec.h"
#include "optimizer/spec/figures.h"
#include "optimizer/spec/match_spec.h"
#include "optimizer/spec/settings.h"
#include "optimizer/spec/words.h"

namespace k3d::optimizer::spec {

namespace {

bool is_name(const std::string& text) {
    return !text.empty() && text.size() <= 64 && text[0] != '.' && text[0] != '-' &&
           std::all_of(text.begin(), text.end(), [](unsigned char c) {
               return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
           });
}

/// A figure that no result has would fail every episode, and only after it has been played.
void check_fitness(const TaskSpec& task, Faults& faults) {
    if (task.fitness.empty()) return;
    const std::string figure = task.fitness.substr(task.fitness.starts_with('-') ? 1 : 0);
    const std::vector<std::string> known = figures_of(task.name);
    if (std::find(known.begin(), known.end(), figure) != known.end()) return;
    faults.add("task.fitness",
               fmt::format("is \"{}\", but a result of {} has {}; with - in front less "
                           "is better",
                           task.fitness, task.name, fmt::join(known, ", ")));
}

/// What the drill's own program would say of the words in its first episode.
void check_drill(const TaskSpec& task, Faults& faults) {
    DrillSpec drill;
    try {
        for (const std::string& word : split_words(task.drill)) {
            const auto equals = word.find('=');
            if (equals == std::string::npos) {
                throw std::invalid_argument(fmt::format("'{}' is not path=value", word));
            }
            config::set(config::describing(drill), word.substr(0, equals), word.substr(equals + 1));
        }
        check(drill);
    } catch (const std::exception& error) {
        faults.add("task.drill", fmt::format("is no list of a drill's settings: {}", error.what()));
    }
}

/// What nobody would read: whoever wrote it expects something of it.
void check_algorithm(const Experiment& e, Faults& faults) {
    for (const std::string& name : kAlgorithmNames) {
        const std::string path = "algorithm." + name;
        if (name == e.algorithm.name) continue;
        // Another algorithm tried beside the file: what the file says of its own one may stay.
        const bool of_file = !faults.is_overridden("algorithm.name") && faults.is_said(path);
        if (!of_file && !faults.is_overridden(path)) continue;
        faults.add(path, fmt::format("is of another algorithm than algorithm.name, \"{}\"",
                                     e.algorithm.name));
    }
}

void check_words(const std::string& path, const std::string& settings, Faults& faults) {
    try {
        parse_settings(settings);
    } catch (const std::invalid_argument& error) {
        faults.add(path, fmt::format("is no list of settings: {}", error.what()));
    }
}

void check_match(const TaskSpec& task, Faults& faults) {
    if (!task.drill.empty()) {
        faults.add("task.drill", "is for drills, but the task is " + task.name);
    }
    try {
        check_command("taker_command", task.taker_command);
    } catch (const std::invalid_argument& error) {
        faults.add("task.taker_command", error.what());
    }
    if (!task.taker_command.empty() && task.tuned != "keeper") {
        faults.add("task.tuned",
                   fmt::format("is \"{}\", but task.taker_command takes no settings", task.tuned));
    }
    if (task.tuned == "taker" && task.fitness.empty()) {
        faults.add("task.fitness", "is missing: takers want \"-hold_time_s\" or the like");
    }
}

void check_task(const TaskSpec& task, Faults& faults) {
    check_fitness(task, faults);
    check_words("task.settings", task.settings, faults);
    if (drill_of(task.name).empty()) return check_match(task, faults);
    for (const char* key :
         {"tuned", "keepers", "takers", "taker", "taker_command", "lobby_s", "hung_agent_s"}) {
        const std::string path = std::string("task.") + key;
        if (faults.is_said(path)) faults.add(path, "is for keepaway, but the task is " + task.name);
    }
    check_drill(task, faults);
}

}  // namespace

void Faults::add(std::string path, const std::string& text) {
    std::optional<int> line;
    const std::string said = path;
    while (!(line = config::line_of(toml_, path)) && path.find('.') != std::string::npos) {
        path.resize(path.rfind('.'));
    }
    faults_.push_back(fmt::format("{}:{}: \"{}\" {}", file_, line.value_or(1), said, text));
}

void Faults::throw_if_any() const {
    if (!faults_.empty()) throw config::ConfigError(fmt::format("{}", fmt::join(faults_, "\n")));
}

bool Faults::is_overridden(const std::string& path) const {
    return std::any_of(overrides_.begin(), overrides_.end(), [&](const std::string& text) {
        return text.starts_with(path + ".") || text.starts_with(path + "=");
    });
}

bool Faults::is_said(const std::string& path) const {
    return config::line_of(toml_, path) || is_overridden(path);
}

void find_faults(const Experiment& e, Faults& faults) {
    if (!is_name(e.name)) {
        faults.add("name", fmt::format("is \"{}\", wanted are letters, digits, _ - .", e.name));
    }
    const bool network = !e.network.path.empty();
    if (network && !e.parameters.empty()) {
        faults.add("parameters", "stands beside [network]; one of them can be tuned");
    }
    const bool all_frozen = std::all_of(e.parameters.begin(), e.parameters.end(),
                                        [](const Parameter& p) { return p.frozen; });
    if (!network && all_frozen) faults.add("parameters", "names nothing that is to be tuned");
    check_algorithm(e, faults);
    check_task(e.task, faults);
    check_words("test.settings", e.test.settings, faults);
}

}  // namespace k3d::optimizer::spec
