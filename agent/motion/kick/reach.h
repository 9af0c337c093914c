// SPDX-License-Identifier: BSD-3-Clause
// Where a ball can be kicked from: for decision, which brings the robot there.
//
// Frames: `ball` of a motion::Kick is in the robot's frame (x forward, y left); stand poses are in
// the frame in which ball and direction are given. Metres, radians.
#pragma once

#include <array>
#include <optional>

#include "agent/motion/kick/config.h"
#include "agent/motion/motion.h"

namespace k3d::agent::kick {

enum class Foot { Right, Left };
enum class Way { Straight, Slant, Square, Farthest };

/// One of the things the engine can do: a swing with a foot.
struct Strike {
    Way way = Way::Straight;
    Foot foot = Foot::Right;

    bool operator==(const Strike&) const = default;
};

/// All of them, the more precise ones first.
inline constexpr std::array<Strike, 8> kStrikes{{{Way::Straight, Foot::Right},
                                                 {Way::Straight, Foot::Left},
                                                 {Way::Slant, Foot::Right},
                                                 {Way::Slant, Foot::Left},
                                                 {Way::Square, Foot::Right},
                                                 {Way::Square, Foot::Left},
                                                 {Way::Farthest, Foot::Right},
                                                 {Way::Farthest, Foot::Left}}};

/// Is it switched on, and the one for about that distance?
bool suits(const Config& config, const Strike& strike, double distance);

/// How far off a stance for this strike may be along the kick, over what is usual.
double stance_share(const Config& config, const Strike& strike);

/// The pose from which this strike sends a ball at `ball` towards `direction`.
Pose2 stand_pose(const Config& config, const Vec2& ball, double direction, const Strike& strike);

/// The strike that can send the ball along kick.direction from where the robot stands now, if any;
/// the best placed one if several can. Straight ahead there is one for any distance, which does what it
/// can.
std::optional<Strike> possible_strike(const Config& config, const motion::Kick& kick);

/// Does the ball lie in reach of a foot for this kick?
inline bool kick_possible(const Config& config, const motion::Kick& kick) {
    return possible_strike(config, kick).has_value();
}

}  // namespace k3d::agent::kick
