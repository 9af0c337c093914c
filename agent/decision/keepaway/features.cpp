// SPDX-License-Identifier: BSD-3-Clause
// Computes f1..f8 of paper 5.3.
#include "agent/decision/keepaway/features.h"

#include <algorithm>
#include <limits>

namespace k3d::agent::decision {
namespace {

constexpr double kNearest = 1e-3;  // m: keeps 1 / distance finite on top of a taker

}  // namespace

Features features_at(const Vec2& p, const PassSituation& s, double ideal_pass) {
    Features f{180.0, 0.0, 0.0, 0.0, 90.0, 90.0, 0.0, 0.0};

    // The two takers nearest to p, the first of equals first.
    std::array<const TakerView*, 2> nearest{};
    std::array<double, 2> squared{std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::infinity()};
    for (const TakerView& taker : s.takers) {
        f[0] = std::min(f[0], degrees(angle_at(s.ball, p, taker.position)));
        f[1] += 1.0 / std::max((p - taker.position).norm(), kNearest);
        const double apart = (taker.position - p).squaredNorm();
        if (apart < squared[0]) {
            nearest = {&taker, nearest[0]};
            squared = {apart, squared[0]};
        } else if (apart < squared[1]) {
            nearest[1] = &taker;
            squared[1] = apart;
        }
    }

    const double off = (p - s.ball).norm() - ideal_pass;
    f[2] = off * off + 1.0;

    double closest = std::numeric_limits<double>::infinity();
    for (const Vec2& receiver : s.receivers) closest = std::min(closest, (p - receiver).squaredNorm());
    f[3] = s.receivers.empty() ? 0.0 : closest;

    for (std::size_t i = 0; i < nearest.size(); ++i) {
        if (nearest[i] == nullptr) break;
        const TakerView& taker = *nearest[i];
        f[4 + i] = degrees(angle_at(taker.position, taker.lagged, p));
        f[6 + i] = (taker.position - taker.lagged).norm();
    }
    return f;
}

PlaceFeatures place_features_at(const Vec2& p, const PassSituation& s, double ideal_pass) {
    const Features f = features_at(p, s, ideal_pass);
    PlaceFeatures all{};
    std::copy(f.begin(), f.end(), all.begin());
    all.back() = (p - s.ball).squaredNorm();
    return all;
}

}  // namespace k3d::agent::decision
