// SPDX-License-Identifier: BSD-3-Clause
#include "agent/decision/keepaway/open_place.h"

#include <algorithm>
#include <cmath>

namespace k3d::agent::decision {

OpenPlace::OpenPlace(const std::string& file, std::vector<Vec2> grid)
    : net_(network::load_file(file), file), state_(net_.start()), grid_(std::move(grid)) {
    network::require_shape(net_, kOpenPlaceNames, 1, file);
}

double OpenPlace::cost(const Vec2& point, const PassSituation& situation, double ideal_pass) {
    const Features f = features_at(point, situation, ideal_pass);
    std::array<double, kOpenPlaceNames.size()> inputs{};
    std::copy(f.begin(), f.end(), inputs.begin());
    inputs.back() = (point - situation.ball).squaredNorm();
    net_.start(state_);  // each place on its own, as targets are
    double cost = 0.0;
    net_.evaluate(inputs, state_, std::span(&cost, 1));
    return cost;
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
