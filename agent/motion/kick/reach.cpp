// SPDX-License-Identifier: BSD-3-Clause
#include "agent/motion/kick/reach.h"

#include <algorithm>
#include <cmath>

namespace k3d::agent::kick {

namespace {

/// +1 if the left foot kicks: its side of the robot.
double side(Foot foot) { return foot == Foot::Left ? 1.0 : -1.0; }

/// Where the ball shall lie in the robot's frame.
Vec2 ball_place(const Config& c, Foot foot) {
    return {c.ball_forward, side(foot) * c.ball_outward};
}

/// Where the ball goes in the robot's frame: a swing may send it a little to the side.
double aim(const Config& c, Foot foot) { return side(foot) * radians(c.aim_outward_deg); }

/// How far off the ball and the direction are, as multiples of what is allowed.
double misfit(const Config& c, const motion::Kick& kick, Foot foot) {
    const Vec2 off = kick.ball - ball_place(c, foot);
    const double turn = std::abs(wrap_angle(kick.direction - aim(c, foot)));
    return std::max({std::abs(off.x()) / c.reach_forward, std::abs(off.y()) / c.reach_sideways,
                     turn / radians(c.reach_direction_deg)});
}

}  // namespace

Pose2 stand_pose(const Config& c, const Vec2& ball, double direction, Foot foot) {
    const double yaw = wrap_angle(direction - aim(c, foot));
    return {ball - rotated(ball_place(c, foot), yaw), yaw};
}

Pose2 stand_pose_near(const Config& c, const Pose2& self, const Vec2& ball, double direction) {
    const Pose2 right = stand_pose(c, ball, direction, Foot::Right);
    const Pose2 left = stand_pose(c, ball, direction, Foot::Left);
    const double to_right = (right.position - self.position).squaredNorm();
    const double to_left = (left.position - self.position).squaredNorm();
    return to_left < to_right ? left : right;
}

std::optional<Foot> kicking_foot(const Config& c, const motion::Kick& kick) {
    const double right = misfit(c, kick, Foot::Right);
    const double left = misfit(c, kick, Foot::Left);
    if (std::min(right, left) > 1.0) return std::nullopt;
    return left < right ? Foot::Left : Foot::Right;
}

}  // namespace k3d::agent::kick
