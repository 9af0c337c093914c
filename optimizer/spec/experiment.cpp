// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/spec/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "optimizer/spec/faults.h"
#include "optimizer/spec/parameter_tree.h"

namespace k3d::optimizer::spec {

namespace {

bool is_whole(double value) {
    return std::floor(value) == value;
}

/// Faults of one parameter; in `path.key` what is wrong.
void check_parameter(const std::string& path, const AgentField& field, const Wanted& w,
                     const Parameter& p, Faults& faults) {
    if (!w.frozen && std::isnan(w.lower)) return faults.add(path + ".lower", "is missing");
    if (!w.frozen && std::isnan(w.upper)) return faults.add(path + ".upper", "is missing");
    if (!(p.lower < p.upper) && !w.frozen) {
        return faults.add(path + ".lower", fmt::format("is {}, which is not below upper, {}",
                                                       p.lower, p.upper));
    }
    if (p.start < p.lower || p.start > p.upper) {
        return faults.add(path + ".start",
                          fmt::format("is {}{}, outside {} to {}", p.start,
                                      std::isnan(w.start) ? " (the agent's own value)" : "",
                                      p.lower, p.upper));
    }
    if (field.integer && !w.integer) {
        return faults.add(path + ".integer", "is false, but the setting takes whole numbers only");
    }
    if (w.integer && !(is_whole(p.lower) && is_whole(p.upper) && is_whole(p.start))) {
        return faults.add(path, "is whole, but lower, upper or start is not");
    }
    if (!(p.deviation > 0.0)) {
        faults.add(path + ".deviation", fmt::format("is {}, wanted is more than 0", p.deviation));
    }
}

VectorProblem chosen(const AgentFields& fields, const ParameterTree& tree, Faults& faults) {
    VectorProblem parameters;
    for (std::size_t i = 0; i < fields.numbers.size(); ++i) {
        const AgentField& field = fields.numbers[i];
        const std::string path = "parameters." + field.path;
        if (!faults.is_said(path)) continue;
        const Wanted& w = tree.wanted()[i];
        Parameter p;
        p.name = field.path;
        p.lower = std::isnan(w.lower) ? field.min : w.lower;
        p.upper = std::isnan(w.upper) ? field.max : w.upper;
        p.start = std::isnan(w.start) ? field.value : w.start;
        p.deviation = std::isnan(w.deviation) ? (p.upper - p.lower) / 5.0 : w.deviation;
        if (w.frozen && !(p.deviation > 0.0 && std::isfinite(p.deviation))) p.deviation = 1.0;
        p.integer = w.integer;
        p.frozen = w.frozen;
        check_parameter(path, field, w, p, faults);
        parameters.push_back(p);
    }
    return parameters;
}

void check_network(Experiment& e, const AgentFields& fields, const ReadFile& read,
                   Faults& faults) {
    if (e.network.path.empty()) {
        if (faults.is_said("network")) faults.add("network.path", "is missing");
        if (e.algorithm.name == "neat") {
            faults.add("algorithm.name", "is neat, which needs a [network]");
        }
        return;
    }
    const auto& texts = fields.texts;
    if (std::find(texts.begin(), texts.end(), e.network.path) == texts.end()) {
        faults.add("network.path",
                   fmt::format("is \"{}\", which is no text among the agent's settings",
                               e.network.path));
    }
    try {
        e.start_network = network::parse(read(e.network.start), e.network.start);
    } catch (const std::exception& error) {
        faults.add("network.start", fmt::format("is \"{}\": {}", e.network.start, error.what()));
    }
}

/// Where fitness may be below 0, a default of 0 would make failing the best there is.
void complete_worst(TaskSpec& task, Faults& faults) {
    if (!std::isnan(task.worst)) return;
    task.worst = 0.0;
    if (drill_of(task.name).empty() && !task.fitness.starts_with('-')) return;
    faults.add("task.worst", "is missing: the fitness of an episode that gave no valid result");
}

}  // namespace

void Experiment::describe(config::Fields& f) {
    f.text("name", name, {}, "of the experiment; its runs are named after it");
    f.text("description", description, {}, "what it is for");
    f.seed("seed", seed, "of the search and of all its episodes");
    f.section("task", task);
    f.section("algorithm", algorithm);
    f.section("budget", budget);
    f.section("test", test);
    f.section("network", network);
}

Experiment parse_experiment(std::string_view toml, const std::string& file,
                            const AgentFields& fields, const ReadFile& read,
                            const Overrides& overrides) {
    Experiment e;
    e.task.worst = Wanted::kUnsaid;
    ParameterTree tree(fields);
    const auto describe = [&](config::Fields& f) {
        e.describe(f);
        f.section("parameters", tree);
    };
    config::load_text(describe, toml, file);
    for (const std::string& text : overrides) {
        const auto equals = text.find('=');
        if (equals == std::string::npos) {
            throw config::ConfigError(fmt::format("--set '{}' is not path=value", text));
        }
        config::set(describe, text.substr(0, equals), text.substr(equals + 1));
    }
    Faults faults(toml, file, overrides);
    e.parameters = chosen(fields, tree, faults);
    e.lists = fields.lists;
    complete_worst(e.task, faults);
    find_faults(e, faults);
    check_network(e, fields, read, faults);
    faults.throw_if_any();
    return e;
}

std::string test_settings(const Experiment& e) {
    if (e.test.settings.empty()) return e.task.settings;
    return e.task.settings + " " + e.test.settings;  // the later word wins
}

Problem problem_of(const Experiment& e) {
    if (!e.start_network) return e.parameters;
    if (e.algorithm.name == "neat") return NetworkProblem{*e.start_network};
    VectorProblem weights;
    const auto add = [&](std::string name, double start) {
        const double bound = std::max(e.network.bound, std::abs(start));
        weights.push_back({std::move(name), start, e.network.deviation, -bound, bound});
    };
    for (const network::Link& link : e.start_network->links) {
        add(link.from + ">" + link.to, link.weight);
    }
    for (const network::Node& node : e.start_network->nodes) add("bias " + node.name, node.bias);
    return weights;
}

std::vector<std::pair<std::string, std::string>> settings_of(const Experiment& e,
                                                             const std::vector<double>& values) {
    std::vector<std::pair<std::string, std::string>> settings;
    std::map<std::string, std::vector<double>> lists;  // with tuned elements
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Parameter& p = e.parameters.at(i);
        const auto dot = p.name.rfind('.');
        const auto list = e.lists.find(p.name.substr(0, dot));
        if (dot != std::string::npos && list != e.lists.end()) {
            auto& whole = lists.try_emplace(list->first, list->second).first->second;
            whole.at(std::stoul(p.name.substr(dot + 1))) = values[i];
        } else {
            settings.emplace_back(p.name, p.integer ? fmt::format("{:.0f}", values[i])
                                                    : fmt::format("{}", values[i]));
        }
    }
    for (const auto& [path, whole] : lists) {
        settings.emplace_back(path, fmt::format("[{}]", fmt::join(whole, ", ")));
    }
    return settings;
}

network::Definition with_weights(const network::Definition& start,
                                 const std::vector<double>& values) {
    network::Definition net = start;
    std::size_t next = 0;
    for (network::Link& link : net.links) link.weight = values.at(next++);
    for (network::Node& node : net.nodes) node.bias = values.at(next++);
    return net;
}

}  // namespace k3d::optimizer::spec
