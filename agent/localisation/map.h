// SPDX-License-Identifier: BSD-3-Clause
// What the field looks like from the team's side, in the forms localisation compares with.
//
// Frame: team frame (agent/world/beliefs.h). Landmark names never flip, so the right team's table
// is turned by 180 degrees; the painted lines are the same for both.
#pragma once

#include <array>

#include "agent/perception/view.h"
#include "common/field/field.h"

namespace k3d::agent::localisation {

using Landmarks = std::array<Vec2, field::kLandmarkCount>;  ///< by field::Landmark, on the ground

Landmarks team_landmarks(wire::Side side);

struct MapLine {
    Vec2 begin;
    Vec2 along;     ///< unit vector from begin to end
    Vec2 normal;    ///< along turned by +90 degrees
    double offset;  ///< normal . p of every point p of the line
    double length;
};

/// The 11 straight lines and the 10 chords of the centre circle.
const std::array<MapLine, field::kLineCount>& map_lines();

/// How far a sighting may lie from the line it is held for.
struct Gate {
    double distance;  ///< m, of either end from the line
    double heading;   ///< sine of the angle between the two
};

/// The line that a sighting, seen from `pose`, is a piece of; none if no line lies within the gate.
const MapLine* match(const Pose2& pose, const perception::LineSight& sight, const Gate& gate);

}  // namespace k3d::agent::localisation
