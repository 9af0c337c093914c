// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/fitness/fitness.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

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

std::string usual_figure(const std::string& task) {
    return task == "keepaway" ? "hold_time_s" : "fitness";
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
    return figure(result, task.fitness.empty() ? usual_figure(task.name) : task.fitness);
}

double simulated_s(const Result& result) {
    return value(result, "simulated_s").value_or(result.hold_time_s);
}

}  // namespace k3d::optimizer::fitness
