// SPDX-License-Identifier: BSD-3-Clause
#include "agent/motion/kick/reach.h"

#include <algorithm>
#include <cmath>

namespace k3d::agent::kick {

namespace {

/// +1 if the left foot kicks: its side of the robot.
double side(Foot foot) { return foot == Foot::Left ? 1.0 : -1.0; }

const Placement& placement(const Config& c, Way way) {
    switch (way) {
        case Way::Straight: return c.straight;
        case Way::Slant: return c.slant.place;
        case Way::Farthest: return c.farthest.place;
        case Way::Square: break;
    }
    return c.square.place;
}

/// Where the ball shall lie in the robot's frame.
Vec2 ball_place(const Placement& p, Foot foot) {
    return {p.ball_forward, side(foot) * p.ball_outward};
}

/// Where the ball goes in the robot's frame.
double aim(const Placement& p, Foot foot) { return side(foot) * radians(p.aim_outward_deg); }

/// How far off the ball and the direction are, as multiples of what is allowed.
double misfit(const Placement& p, const motion::Kick& kick, Foot foot) {
    const Vec2 off = kick.ball - ball_place(p, foot);
    const double turn = std::abs(wrap_angle(kick.direction - aim(p, foot)));
    return std::max({std::abs(off.x()) / p.reach_forward, std::abs(off.y()) / p.reach_sideways,
                     turn / radians(p.reach_direction_deg)});
}

}  // namespace

bool suits(const Config& c, const Strike& strike, double distance) {
    const bool beyond = c.farthest.on && distance > c.farthest.from_m;
    if (strike.way == Way::Straight) return !beyond;
    if (strike.way == Way::Farthest) return beyond;
    const AngledSwing& angled = strike.way == Way::Slant ? c.slant : c.square;
    return angled.on && std::abs(distance - angled.swing.reach_m) <= c.angled_miss_m;
}

double stance_share(const Config& c, const Strike& strike) {
    return strike.way == Way::Farthest ? c.farthest.stance_share : 1.0;
}

Pose2 stand_pose(const Config& c, const Vec2& ball, double direction, const Strike& strike) {
    const Placement& p = placement(c, strike.way);
    const double yaw = wrap_angle(direction - aim(p, strike.foot));
    return {ball - rotated(ball_place(p, strike.foot), yaw), yaw};
}

std::optional<Strike> possible_strike(const Config& c, const motion::Kick& kick) {
    std::optional<Strike> best;
    double least = 1.0;
    for (const Strike& strike : kStrikes) {
        if (!suits(c, strike, kick.distance)) continue;
        const double off = misfit(placement(c, strike.way), kick, strike.foot);
        if (off > least || (best && off == least)) continue;
        least = off;
        best = strike;
    }
    return best;
}

}  // namespace k3d::agent::kick
