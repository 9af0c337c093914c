// SPDX-License-Identifier: BSD-3-Clause
// The one table of the field: dimensions, landmarks, lines, solid objects and ball.
// Physics, percepts, localisation and the page all read it.
//
// Frame: origin at the field's centre on the ground, x from the left goal to the right goal,
// y to the left when facing +x, z up. Metres, kilograms. Source: SimSpark reference 6.
#pragma once

#include <array>
#include <string_view>

#include "common/math/geometry.h"

namespace k3d::field {

inline constexpr double kLength = 30.0;
inline constexpr double kWidth = 20.0;
inline constexpr double kHeight = 40.0;  // told to monitors only
inline constexpr double kGoalWidth = 2.1;
inline constexpr double kGoalDepth = 0.6;
inline constexpr double kGoalHeight = 0.8;
inline constexpr double kPenaltyLength = 1.8;
inline constexpr double kPenaltyWidth = 6.0;
inline constexpr double kCentreRadius = 2.0;
inline constexpr double kAgentRadius = 0.4;

inline constexpr double kBallRadius = 0.042;
inline constexpr double kBallMass = 0.026;
/// Speed decay of a rolling ball, 1/s: dv/dt = -kRollDecay * v (reference 6.5, measured A.3 (i)).
inline constexpr double kRollDecay = 1.06;

/// Landmarks in the order of the See percept (reference 3.6, 6.2). Names never flip with the team.
enum class Landmark { G1L, G2L, G2R, G1R, F1L, F2L, F1R, F2R };
inline constexpr int kLandmarkCount = 8;

struct LandmarkDef {
    std::string_view name;
    double x, y, z;
};
inline constexpr std::array<LandmarkDef, kLandmarkCount> kLandmarks{{
    {"G1L", -15.0, 1.05, 0.8},
    {"G2L", -15.0, -1.05, 0.8},
    {"G2R", 15.0, -1.05, 0.8},
    {"G1R", 15.0, 1.05, 0.8},
    {"F1L", -15.0, 10.0, 0.0},
    {"F2L", -15.0, -10.0, 0.0},
    {"F1R", 15.0, 10.0, 0.0},
    {"F2R", 15.0, -10.0, 0.0},
}};

/// A painted line on the ground, from begin to end.
struct Line {
    Vec2 begin;
    Vec2 end;
};
inline constexpr int kLineCount = 21;
/// The 11 straight lines and the 10 chords of the centre circle, in definition order (reference 6.3).
const std::array<Line, kLineCount>& lines();
inline constexpr int kStraightLineCount = 11;  // the first 11 of lines() are straight lines

/// A solid axis-aligned box: walls and goal panels (reference 6.4).
struct SolidBox {
    std::string_view name;
    Vec3 centre;
    Vec3 size;
};
inline constexpr int kSolidCount = 12;
const std::array<SolidBox, kSolidCount>& solids();

}  // namespace k3d::field
