// SPDX-License-Identifier: BSD-3-Clause
#include "agent/decision/keepaway/open_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace k3d::agent::decision {

namespace {

network::Network load(const std::string& file) {
    network::Network net(network::load_file(file), file);
    constexpr std::array<std::string_view, 1> kCost{"cost"};
    network::require_shape(net, kPlaceFeatureNames, kCost, file);
    return net;
}

}  // namespace

OpenPlace::OpenPlace(const std::string& file, std::vector<Vec2> grid)
    : OpenPlace(load(file), std::move(grid)) {}

OpenPlace::OpenPlace(network::Network net, std::vector<Vec2> grid)
    : net_(std::move(net)),
      state_(net_.start()),
      outputs_(net_.definition().outputs.size()),
      grid_(std::move(grid)) {}

double OpenPlace::cost(const Vec2& point, const PassSituation& situation, double ideal_pass) {
    net_.start(state_);  // each place on its own, as targets are
    net_.evaluate(place_features_at(point, situation, ideal_pass), state_, outputs_);
    return outputs_.back();
}

Vec2 OpenPlace::choose(const PassSituation& situation, double ideal_pass) {
    Vec2 best = grid_.front();
    double least = cost(best, situation, ideal_pass);
    for (const Vec2& point : grid_) {
        const double c = cost(point, situation, ideal_pass);
        if (c < least) {
            least = c;
            best = point;
        }
    }
    const bool keeps = before_ && cost(*before_, situation, ideal_pass) <=
                                      least + kKeep * std::abs(least);
    if (!keeps) before_ = best;
    return *before_;
}

}  // namespace k3d::agent::decision
