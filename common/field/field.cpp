// SPDX-License-Identifier: BSD-3-Clause
#include "common/field/field.h"

namespace k3d::field {

namespace {

std::array<Line, kLineCount> make_lines() {
    constexpr double H = kLength / 2.0;
    constexpr double W = kWidth / 2.0;
    constexpr double P = H - kPenaltyLength;
    constexpr double q = kPenaltyWidth / 2.0;
    std::array<Line, kLineCount> all{{
        {{0, -W}, {0, W}},
        {{H, -W}, {H, W}},
        {{-H, -W}, {-H, W}},
        {{H, W}, {-H, W}},
        {{H, -W}, {-H, -W}},
        {{P, q}, {P, -q}},
        {{P, q}, {H, q}},
        {{P, -q}, {H, -q}},
        {{-P, q}, {-P, -q}},
        {{-P, q}, {-H, q}},
        {{-P, -q}, {-H, -q}},
    }};
    constexpr int chords = kLineCount - kStraightLineCount;
    for (int k = 0; k < chords; ++k) {
        const double from = 2.0 * kPi * k / chords;
        const double to = 2.0 * kPi * (k + 1) / chords;
        all[static_cast<std::size_t>(kStraightLineCount + k)] = {kCentreRadius * direction(from),
                                                                kCentreRadius * direction(to)};
    }
    return all;
}

std::array<SolidBox, kSolidCount> make_solids() {
    constexpr double wall_x = kLength / 2.0 + 0.333 * kLength;
    constexpr double wall_y = kWidth / 2.0 + 0.75 * kWidth;
    constexpr double goal_x = kLength / 2.0 + kGoalDepth / 2.0;
    constexpr double goal_z = kGoalHeight / 2.0;
    std::array<SolidBox, kSolidCount> all{{
        {"wall-left", {-wall_x, 0, 0}, {1, 51, 1}},
        {"wall-right", {wall_x, 0, 0}, {1, 51, 1}},
        {"wall-front", {0, -wall_y, 0}, {50.98, 1, 1}},
        {"wall-back", {0, wall_y, 0}, {50.98, 1, 1}},
    }};
    // Goal panels in the left goal's frame, whose +x points into the field; the right goal is
    // turned by 180 degrees, which for boxes means mirrored offsets.
    std::size_t next = 4;
    for (const double side : {-1.0, 1.0}) {
        const bool left = side < 0.0;
        const Vec3 origin(side * goal_x, 0, goal_z);
        all[next++] = {left ? "goal-left-panel-1" : "goal-right-panel-1",
                       origin + Vec3(0, -side * 1.07, 0), {0.6, 0.04, 0.8}};
        all[next++] = {left ? "goal-left-panel-2" : "goal-right-panel-2",
                       origin + Vec3(0, side * 1.07, 0), {0.6, 0.04, 0.8}};
        all[next++] = {left ? "goal-left-back" : "goal-right-back",
                       origin + Vec3(side * 0.28, 0, 0), {0.04, 2.1, 0.8}};
        all[next++] = {left ? "goal-left-roof" : "goal-right-roof",
                       origin + Vec3(0, 0, 0.42), {0.6, 2.18, 0.04}};
    }
    return all;
}

}  // namespace

const std::array<Line, kLineCount>& lines() {
    static const std::array<Line, kLineCount> all = make_lines();
    return all;
}

const std::array<SolidBox, kSolidCount>& solids() {
    static const std::array<SolidBox, kSolidCount> all = make_solids();
    return all;
}

}  // namespace k3d::field
