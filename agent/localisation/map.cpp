// SPDX-License-Identifier: BSD-3-Clause
#include "agent/localisation/map.h"

#include <algorithm>

namespace k3d::agent::localisation {

namespace {

constexpr double kAngleBlur = 0.008;  // rad: about three deviations of vision's angle

}  // namespace

Landmarks team_landmarks(wire::Side side) {
    const double sign = side == wire::Side::Right ? -1.0 : 1.0;
    Landmarks all;
    for (std::size_t k = 0; k < all.size(); ++k) {
        all[k] = sign * Vec2(field::kLandmarks[k].x, field::kLandmarks[k].y);
    }
    return all;
}

const std::array<MapLine, field::kLineCount>& map_lines() {
    static const auto all = [] {
        std::array<MapLine, field::kLineCount> made;
        for (std::size_t k = 0; k < made.size(); ++k) {
            const field::Line& line = field::lines()[k];
            const Vec2 along = (line.end - line.begin).normalized();
            const Vec2 normal(-along.y(), along.x());
            made[k] = {line.begin, along, normal, normal.dot(line.begin),
                       (line.end - line.begin).norm()};
        }
        return made;
    }();
    return all;
}

const MapLine* match(const Pose2& pose, const perception::LineSight& sight, const Gate& gate) {
    const Vec2 begin = pose.to_global(sight.begin);
    const Vec2 end = pose.to_global(sight.end);
    const Vec2 heading = (end - begin) / sight.length;
    // A short piece far away shows its direction badly.
    const double blur = kAngleBlur * std::max(sight.begin.norm(), sight.end.norm()) / sight.length;
    const MapLine* best = nullptr;
    double best_cost = 1.0;
    for (const MapLine& line : map_lines()) {
        const double turn = std::abs(line.normal.dot(heading));
        if (turn > gate.heading + blur) continue;
        const double off = std::max(std::abs(line.normal.dot(begin) - line.offset),
                                    std::abs(line.normal.dot(end) - line.offset));
        if (off > gate.distance) continue;
        const double from = line.along.dot(begin - line.begin);
        const double to = line.along.dot(end - line.begin);
        const double outside =
            std::max({0.0, -std::min(from, to), std::max(from, to) - line.length});
        if (outside > gate.distance) continue;
        const double cost = (off + outside) / (2.0 * gate.distance);
        if (cost <= best_cost) {
            best_cost = cost;
            best = &line;
        }
    }
    return best;
}

}  // namespace k3d::agent::localisation
