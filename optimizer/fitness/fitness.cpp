// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/fitness/fitness.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "optimizer/fitness/drills.h"

namespace k3d::optimizer::fitness {

namespace {

using k3d::episode::Result;

std::optional<double> value(const Result& r, const std::string& name) {
    if (name == "hold_time_s") return r.hold_time_s;
    if (name == "kicks") return r.kicks;
    if (name == "passes_completed") return r.passes_completed;
    if (name == "attempts") {
        return r.attempts ? std::optional<double>(*r.attempts) : std::nullopt;
    }
    if (name == "falls") {
        double falls = 0.0;
        for (const auto& player : r.players) falls += player.falls;
        return falls;
    }
    const auto metric = r.metrics.find(name);
    return metric == r.metrics.end() ? std::nullopt : std::optional(metric->second);
}

}  // namespace

std::string measure(const spec::TaskSpec& task) {
    if (!task.fitness.empty()) return task.fitness;
    return task.name == "keepaway" ? "hold_time_s" : task.name;
}

tl::expected<double, std::string> figure(const Result& result, const std::string& name) {
    const bool less = name.starts_with('-');
    const auto found = value(result, less ? name.substr(1) : name);
    if (!found) return tl::unexpected(fmt::format("the result has no '{}'", name));
    if (!std::isfinite(*found)) {
        return tl::unexpected(fmt::format("'{}' is {} in the result", name, *found));
    }
    return less ? -*found : *found;
}

tl::expected<double, std::string> fitness(const spec::TaskSpec& task, const Result& result) {
    if (!task.fitness.empty()) return figure(result, task.fitness);
    const auto checked = [](const std::optional<double>& worth)
        -> tl::expected<double, std::string> {
        if (!worth) {
            return tl::unexpected(
                std::string("the drill has not measured what its fitness needs"));
        }
        if (!std::isfinite(*worth)) return tl::unexpected(fmt::format("the fitness is {}", *worth));
        return *worth;
    };
    if (task.name == "walk_forward") return checked(walk_forward(result));
    if (task.name == "walk_turn") return checked(walk_turn(result));
    if (task.name == "go_to") return checked(go_to(result));
    if (task.name == "kick") return checked(kick(result));
    if (task.name == "possession") return checked(possession(result));
    if (task.name == "ball_prediction") return checked(ball_prediction(result));
    return figure(result, measure(task));
}

double simulated_s(const Result& result) {
    return value(result, "simulated_s").value_or(result.hold_time_s);
}

}  // namespace k3d::optimizer::fitness
