// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/fitness/drills.h"

#include <algorithm>
#include <numbers>

namespace k3d::optimizer::fitness {

namespace {

using k3d::episode::Result;

constexpr double kWalkLimit = 30.0;       // s
constexpr double kDriftCost = 0.2;        // rad/s per m
constexpr double kFallCost = 0.05;        // m/s per fall in ten minutes
constexpr double kNoKick = -(25.0 + 5.0);  // s

std::optional<double> metric(const Result& r, const char* name) {
    const auto found = r.metrics.find(name);
    return found == r.metrics.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

std::optional<double> walk_forward(const Result& r) {
    const auto way = metric(r, "distance_m");
    if (r.reason == "fell") return way ? std::optional(*way / kWalkLimit) : std::nullopt;
    return metric(r, "speed_mps");
}

std::optional<double> walk_turn(const Result& r) {
    const auto rate_deg = metric(r, "turn_deg_per_s");
    const auto drift = metric(r, "drift_m");
    if (!rate_deg || !drift) return std::nullopt;
    if (r.reason == "fell") return 0.0;
    return *rate_deg * std::numbers::pi / 180.0 - kDriftCost * *drift;
}

std::optional<double> go_to(const Result& r) {
    const auto falls = metric(r, "falls_per_10_min");
    if (!falls) return std::nullopt;
    // Without a way there was no target within reach: it has not moved towards any.
    return metric(r, "speed_to_target_mps").value_or(0.0) - kFallCost * *falls;
}

std::optional<double> kick(const Result& r) {
    return metric(r, "fitness_capped");
}

std::optional<double> possession(const Result& r) {
    if (const auto time = metric(r, "time_to_kick_s")) return std::max(-*time, kNoKick);
    return metric(r, "succeeded") ? std::optional(kNoKick) : std::nullopt;
}

std::optional<double> ball_prediction(const Result& r) {
    const auto loss = metric(r, "finish_loss");
    return loss ? std::optional(-*loss) : std::nullopt;
}

}  // namespace k3d::optimizer::fitness
