// SPDX-License-Identifier: BSD-3-Clause
// Walking to a place: far away turned as takes the least time until the final heading (forward,
// mostly), near it in any direction with the final heading; around other robots. Team frame in, walk
// request in the robot's frame out.
#pragma once

#include <span>
#include <vector>

#include "agent/motion/motion.h"
#include "agent/skills/config.h"
#include "agent/world/beliefs.h"
#include "common/math/geometry.h"

namespace k3d::agent::skills {

/// Something round to walk around.
struct Obstacle {
    Vec2 position;
    double clearance;  ///< m to keep between its centre and ours
};

/// All robots that are known, in place of what `robots` held.
void robots_of(const world::Beliefs& beliefs, double clearance, std::vector<Obstacle>& robots);

/// Where to head first so as to reach `goal` without running into an obstacle: the goal itself
/// if the way is free, else a point beside the nearest obstacle in the way. An obstacle that
/// stands on the goal is not avoided.
Vec2 waypoint(const Vec2& self, const Vec2& goal, std::span<const Obstacle> obstacles);

/// Velocity towards `goal`, slowing down to stop there with goal.yaw.
motion::Walk walk_to(const Pose2& self, const Pose2& goal, std::span<const Obstacle> obstacles,
                     const SkillConfig& config);

/// Velocity towards a point at full speed, without slowing down or caring for the heading there.
motion::Walk walk_onto(const Pose2& self, const Vec2& goal, std::span<const Obstacle> obstacles,
                       const SkillConfig& config);

/// walk_to() that stands still once there and starts again only when clearly off.
class GoTo {
  public:
    motion::BodyRequest step(const Pose2& self, const Pose2& goal,
                             std::span<const Obstacle> obstacles, const SkillConfig& config);
    void reset() { arrived_ = false; }

  private:
    bool arrived_ = false;
};

}  // namespace k3d::agent::skills
