// SPDX-License-Identifier: BSD-3-Clause
// Where a ball can be kicked from: for decision, which brings the robot there.
//
// Frames: `ball` of a motion::Kick is in the robot's frame (x forward, y left); stand poses are in
// the frame in which ball and direction are given. Metres, radians.
#pragma once

#include <optional>

#include "agent/motion/kick/config.h"
#include "agent/motion/motion.h"

namespace k3d::agent::kick {

enum class Foot { Right, Left };

/// The pose from which this foot sends a ball at `ball` towards `direction`.
Pose2 stand_pose(const Config& config, const Vec2& ball, double direction, Foot foot);

/// The same with the foot whose stand pose is nearer to `self`.
Pose2 stand_pose_near(const Config& config, const Pose2& self, const Vec2& ball, double direction);

/// The foot that can send the ball along kick.direction from where the robot stands now, if any;
/// the better placed one if both can. Distance plays no role: the engine does what it can.
std::optional<Foot> kicking_foot(const Config& config, const motion::Kick& kick);

/// Does the ball lie in reach of a foot for this kick?
inline bool kick_possible(const Config& config, const motion::Kick& kick) {
    return kicking_foot(config, kick).has_value();
}

}  // namespace k3d::agent::kick
