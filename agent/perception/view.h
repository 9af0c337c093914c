// SPDX-License-Identifier: BSD-3-Clause
// From one See percept to sightings on the ground around the robot.
//
// Frame: the level robot frame of agent/motion/motion.h (origin on the ground below the torso, x
// along its heading, y left, z up). Metres. A See describes the same instant as the joints of its
// frame, so the camera pose of that cycle is the right one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "agent/motion/motion.h"
#include "common/field/field.h"
#include "common/wire/percepts.h"

namespace k3d::agent::perception {

struct LandmarkSight {
    field::Landmark landmark;
    Vec2 position;
};

/// A piece of a line; its ends may be where the view ends, so only its course counts.
struct LineSight {
    Vec2 begin;
    Vec2 end;
    double length;
};

struct PlayerSight {
    bool mate;
    int unum;
    Vec2 position;               ///< middle of what was seen of head and feet, else of the arms
    std::optional<bool> fallen;  ///< none if the head was out of view
};

struct View {
    std::vector<LandmarkSight> landmarks;
    std::vector<LineSight> lines;
    std::optional<Vec3> ball;                 ///< centre
    std::vector<PlayerSight> players;         ///< without this agent's own limbs
    Vec3 camera = Vec3::Zero();               ///< as levelled: position in the robot frame
    Quat camera_rotation = Quat::Identity();  ///< as levelled: camera axes -> robot frame
};

/// Who looks: other players are judged by it, own arms recognised.
struct Identity {
    std::string team;
    int unum = 0;  ///< 0 = not told yet: then nothing is known of players of the own team
};

/// Camera axes (x forward, y left, z up) from the wire's polar form.
Vec3 to_camera(const wire::Pol& pol);

/// Converts `see` into `view`, whose buffers are reused. Sightings that are not finite are dropped.
///
/// The camera's roll and pitch are first corrected so that the seen lines lie on the ground
/// (level.h): the body's own idea of its tilt is off by a degree or so in a walk, and 1 degree is
/// 9 mm of ball position at the foot.
void look(const wire::See& see, const motion::State& body, const Identity& self, View& view);

}  // namespace k3d::agent::perception
