// SPDX-License-Identifier: BSD-3-Clause
// Cost of target points and the choice among them.
#include "agent/decision/keepaway/policy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string_view>

namespace k3d::agent::decision {

double hand_coded_cost(const Features& f, const EvaluationConfig& c) {
    const auto [f1, f2, f3, f4, f5, f6, f7, f8] = f;
    const bool coming_towards = (f5 < c.towards_deg && f7 > c.moved) ||
                                (f6 < c.towards_deg && f8 > c.moved);
    const bool going_away = (f5 > c.away_deg && f7 > c.moved) || (f6 > c.away_deg && f8 > c.moved);
    const double value = f2 * f3 / std::max(f1, c.floor_deg);
    if (f4 > c.far_receiver || f3 > c.bad_length || f1 < c.narrow_deg || coming_towards)
        return value + c.penalty;
    if (going_away) return value / c.away_divisor;
    return value;
}

std::vector<Vec2> target_grid(double area, const EvaluationConfig& c) {
    // Rounding first: 0.4 * 10 / 1 must count as 4 whole cells.
    const double half = area * (0.5 - c.margin);
    const int count = static_cast<int>(std::floor(half / c.cell + 1e-9));
    std::vector<Vec2> grid;
    for (int x = -count; x <= count; ++x)
        for (int y = -count; y <= count; ++y) grid.emplace_back(x * c.cell, y * c.cell);
    return grid;
}

namespace {

// A network's outputs.
constexpr std::array<std::string_view, 1> kTargetCost{"cost"};
constexpr std::array<std::string_view, 2> kBothCosts{"cost", "place"};

}  // namespace

Policy load_policy(const std::string& name) {
    if (name == "handcoded") return {};
    if (name == "still") return {.kind = Policy::Kind::Still};
    if (name == "hold") return {.kind = Policy::Kind::Hold};
    if (name == "random") return {.kind = Policy::Kind::Random};
    if (!std::filesystem::exists(name))
        throw network::NetworkError("keeper.policy \"" + name +
                                    "\" is none of handcoded, still, hold, random, and there is no "
                                    "such network file");
    network::Network net(network::load_file(name), name);
    const bool values_places = net.definition().outputs.size() == 2;
    if (values_places) {
        network::require_shape(net, kPlaceFeatureNames, kBothCosts, name);
    } else {
        network::require_shape(net, kFeatureNames, kTargetCost, name);
    }
    return {Policy::Kind::Evaluate, std::move(net), values_places};
}

Target best_target(const std::vector<Vec2>& grid, const PassSituation& situation,
                   const Policy& policy, const EvaluationConfig& config, const Room& room,
                   const std::optional<Vec2>& previous, double keep,
                   std::vector<Scored>* scored) {
    static thread_local network::State state;  // kept between calls only for its memory
    static thread_local std::vector<Scored> own;  // likewise
    std::vector<Scored>& all = scored != nullptr ? *scored : own;
    all.clear();
    const auto cost_at = [&](const Vec2& point) {
        if (!policy.cost) {
            return hand_coded_cost(features_at(point, situation, config.ideal_pass_m), config);
        }
        // Each point is judged on its own: recurrent links of a network start from zero.
        policy.cost->start(state);
        const PlaceFeatures f = place_features_at(point, situation, config.ideal_pass_m);
        const network::Definition& net = policy.cost->definition();
        std::array<double, 2> costs{};
        policy.cost->evaluate(std::span(f).first(net.inputs.size()), state,
                              std::span(costs).first(net.outputs.size()));
        return costs.front();
    };
    std::optional<Target> best;
    std::optional<Target> kept;
    Vec2 roomiest = Vec2::Zero();
    double most_room = -std::numeric_limits<double>::infinity();
    for (const Vec2& point : grid) {
        if ((point - situation.ball).norm() < config.min_pass) continue;
        const double space = room(point);
        if (space > most_room) {
            most_room = space;
            roomiest = point;
        }
        if (space < 0.0) continue;
        const Target candidate{point, cost_at(point)};
        all.push_back({point, candidate.cost});
        if (!best || candidate.cost < best->cost) best = candidate;
        if (previous && (point - *previous).norm() < 1e-6) kept = candidate;
    }
    if (!best) return {roomiest, cost_at(roomiest)};
    if (!kept) return *best;
    const auto better =
        std::ranges::count_if(all, [&](const Scored& other) { return other.cost < kept->cost; });
    return static_cast<double>(better) <= keep * static_cast<double>(all.size()) ? *kept : *best;
}

}  // namespace k3d::agent::decision
