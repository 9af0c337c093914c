// SPDX-License-Identifier: BSD-3-Clause
// Where to look: follow the ball and swing across it, so that landmarks and players come into
// view; search when it is lost, in the end with the whole body.
#pragma once

#include <optional>

#include "agent/motion/motion.h"
#include "agent/skills/config.h"
#include "agent/world/beliefs.h"

namespace k3d::agent::skills {

/// Head angles that put a point on the ground (robot frame) in the middle of the picture, within
/// the neck's range. `camera_height` m.
motion::HeadRequest look_at(const Vec2& point, double camera_height);

/// Head request of this cycle. `busy`: at the ball, keep it well in view.
motion::HeadRequest look(const world::Beliefs& beliefs, const motion::State& body, bool busy,
                         const SkillConfig& config);

/// A turn on the spot if the ball is lost so long that the body has to help; towards the place
/// where team-mates say it is, if they do.
std::optional<motion::Walk> search_turn(const world::Beliefs& beliefs, const SkillConfig& config);

}  // namespace k3d::agent::skills
