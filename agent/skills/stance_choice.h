// SPDX-License-Identifier: BSD-3-Clause
// Which of the engine's kicks to prepare for: the one whose stance is taken soonest. Team frame,
// metres, radians, seconds.
#pragma once

#include <functional>

#include "agent/motion/motion.h"
#include "agent/skills/config.h"
#include "common/math/geometry.h"

namespace k3d::agent::skills {

/// What the kick engine says about its reach; functions, so that tests can do without an engine.
struct KickGeometry {
    int strikes = 1;  ///< how many kicks there are to choose from; the more precise come first
    /// Is this one of use for a kick so far?
    std::function<bool(int strike, double distance)> suits;
    /// Pose from which this one sends a ball at `ball` towards `yaw`, in the frame of the two.
    std::function<Pose2(int strike, const Vec2& ball, double yaw)> stand_pose;
    /// Can the engine strike this ball from here (robot frame)?
    std::function<bool(const motion::Kick&)> possible;
    /// How far the ball goes, m, when so much is wanted: engines have few swings.
    std::function<double(double wanted)> reach;
    /// How far off a stance may be along the kick, as a share of config.kick_tolerance_x.
    std::function<double(int strike)> stance_share = [](int) { return 1.0; };
};

/// The same, for one who never asks for more than `longest` metres: what is wanted beyond is done with
/// the kicks for that.
KickGeometry no_farther(const KickGeometry& kick, double longest);

/// A pose from which the ball can be kicked where it shall go.
struct Stance {
    int strike = 0;
    Pose2 pose;
    double time = 0.0;  ///< s until the robot stands there
};

/// About how long a robot at `self` takes to stand at `stance` without touching the ball.
double time_to_stand(const Pose2& self, const Pose2& stance, const Vec2& ball,
                     const SkillConfig& config);

/// The stance taken soonest. The `kept` strike is preferred unless another saves
/// config.strike_keep_s; it may be one there is not.
Stance soonest_stance(const Pose2& self, const Vec2& ball, const Vec2& target, int kept,
                      const KickGeometry& kick, const SkillConfig& config);

}  // namespace k3d::agent::skills
