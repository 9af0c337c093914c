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

    std::vector<const TakerView*> by_distance;
    for (const TakerView& taker : s.takers) {
        f[0] = std::min(f[0], degrees(angle_at(s.ball, p, taker.position)));
        f[1] += 1.0 / std::max((p - taker.position).norm(), kNearest);
        by_distance.push_back(&taker);
    }

    const double off = (p - s.ball).norm() - ideal_pass;
    f[2] = off * off + 1.0;

    double closest = std::numeric_limits<double>::infinity();
    for (const Vec2& receiver : s.receivers) closest = std::min(closest, (p - receiver).squaredNorm());
    f[3] = s.receivers.empty() ? 0.0 : closest;

    std::stable_sort(by_distance.begin(), by_distance.end(),
                     [&](const TakerView* a, const TakerView* b) {
                         return (a->position - p).squaredNorm() < (b->position - p).squaredNorm();
                     });
    for (std::size_t i = 0; i < std::min<std::size_t>(2, by_distance.size()); ++i) {
        const TakerView& taker = *by_distance[i];
        f[4 + i] = degrees(angle_at(taker.position, taker.lagged, p));
        f[6 + i] = (taker.position - taker.lagged).norm();
    }
    return f;
}

}  // namespace k3d::agent::decision
