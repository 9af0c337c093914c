// SPDX-License-Identifier: BSD-3-Clause
// Positioning for a kick (paper 4.1, POSITION): walk around the ball without touching it, stand
// where the kick wants us, and kick once allowed and well placed.
#pragma once

#include <span>

#include "agent/motion/motion.h"
#include "agent/skills/config.h"
#include "agent/skills/go_to.h"
#include "agent/skills/stance_choice.h"
#include "common/math/geometry.h"

namespace k3d::agent::skills {

struct KickSituation {
    Pose2 self;         ///< team frame
    Vec2 ball;          ///< where it lies or will come to rest
    Vec2 ball_now;      ///< where a swing begun now hits it; kicked only when that is `ball`
    Vec2 target;
    double pressure = 0.0;   ///< 0 = nobody near, 1 = a taker at the ball: then be less choosy
    bool may_kick = false;   ///< else stand ready at the ball
    bool standing = false;   ///< the robot does not walk at the moment
    bool committed = false;  ///< a kick was asked for the cycle before; the robot comes to a stop
    bool arrived = true;     ///< the ball has come as near to `ball` as it will
    bool rolling = false;    ///< it will not lie there: a robot that stands well must not step
    int strike = 0;          ///< of KickGeometry: the kick prepared for
};

/// Error of a stance in the stance's own frame, as multiples of the tolerances at this pressure; along
/// the kick only a share of the tolerance may be allowed.
struct StanceError {
    double x, y, yaw;        ///< m, m, rad
    double worst;            ///< <= 1: good enough
};
StanceError stance_error(const Pose2& self, const Pose2& stance, double pressure,
                         const SkillConfig& config, double stance_share = 1.0);

/// Kick when placed and allowed, stand when placed, walk into the strike's stance otherwise.
motion::BodyRequest position_for_kick(const KickSituation& situation, const KickGeometry& kick,
                                      std::span<const Obstacle> robots, const SkillConfig& config);

}  // namespace k3d::agent::skills
