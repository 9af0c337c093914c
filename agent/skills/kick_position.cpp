// SPDX-License-Identifier: BSD-3-Clause
// Around the ball, into the stance, kick.
#include "agent/skills/kick_position.h"

#include <algorithm>
#include <cmath>

namespace k3d::agent::skills {
namespace {

constexpr double kTouchRadius = 0.24;              // feet reach this far from the torso's centre
constexpr double kArcStep = radians(50.0);         // way around the ball taken at once
constexpr double kCommitted = 1.7;                 // more error is let pass once a kick was asked
constexpr double kStopping = 3.0;                  // and while it stops, which sways by centimetres
constexpr double kHurry = 0.5;                     // pressure from which a fall is risked
constexpr double kAtRest = 0.06;                   // ball counts as come to rest this close
constexpr double kFreeArc = radians(35.0);         // this far from straight behind needs no detour

/// Does the straight way pass so near the ball that feet would touch it?
bool way_touches(const Vec2& from, const Vec2& to, const Vec2& ball) {
    const Vec2 way = to - from;
    const double squared = way.squaredNorm();
    const double share = squared < 1e-9 ? 0.0 : std::clamp((ball - from).dot(way) / squared, 0.0, 1.0);
    return (from + share * way - ball).norm() < kTouchRadius;
}

}  // namespace

StanceError stance_error(const Pose2& self, const Pose2& stance, double pressure,
                         const SkillConfig& c, double stance_share) {
    const Vec2 offset = stance.to_local(self.position);
    const double loose = 1.0 + (c.kick_loosen - 1.0) * pressure;
    const double loose_yaw = 1.0 + (c.kick_loosen_yaw - 1.0) * pressure;
    StanceError e{offset.x(), offset.y(), wrap_angle(self.yaw - stance.yaw), 0.0};
    e.worst = std::max({std::abs(e.x) / (c.kick_tolerance_x * stance_share * loose),
                        std::abs(e.y) / (c.kick_tolerance_y * loose),
                        std::abs(e.yaw) / (c.kick_tolerance_yaw * loose_yaw)});
    return e;
}

motion::BodyRequest position_for_kick(const KickSituation& s, const KickGeometry& kick,
                                      std::span<const Obstacle> robots, const SkillConfig& c) {
    const Vec2 shot = s.target - s.ball;
    const double yaw = yaw_of(shot);
    const Pose2 stance = kick.stand_pose(s.strike, s.ball, yaw);
    const StanceError error =
        stance_error(s.self, stance, s.pressure, c, kick.stance_share(s.strike));

    const motion::Kick request{s.self.to_local(s.ball_now), wrap_angle(yaw - s.self.yaw), shot.norm(),
                               s.pressure > kHurry};
    const bool there = (s.ball_now - s.ball).norm() < kAtRest;
    const bool must_stay = s.committed || (s.rolling && s.standing);
    const bool stopping = s.committed && !s.standing;
    const double allowed = stopping ? kStopping : must_stay ? kCommitted : 1.0;
    const bool placed = there && s.arrived && error.worst <= allowed &&
                        (stopping || kick.possible(request));
    if (placed && s.may_kick) return request;
    // At leisure a looser stance is left alone: shuffling about next to the ball only moves it. And
    // who waits for the ball must stand quietly when it comes.
    const bool waits = !s.may_kick || !there || !s.arrived;
    if (waits && error.worst <= (s.standing ? c.leisure : 0.8)) return motion::Stand{};

    const Vec2 from_ball = s.self.position - s.ball;
    const double around = wrap_angle(yaw_of(stance.position - s.ball) - yaw_of(from_ball));
    const bool behind = std::abs(around) < kFreeArc;
    if (!behind && way_touches(s.self.position, stance.position, s.ball)) {
        const double arc = yaw_of(from_ball) + std::clamp(around, -kArcStep, kArcStep);
        const Vec2 next = s.ball + direction(arc) * c.circle_radius;
        return walk_to(s.self, {next, stance.yaw}, robots, c);
    }
    // Turn before stepping up: a foot that swings around beside the ball pushes it away.
    if (std::abs(error.yaw) > radians(30.0) && from_ball.norm() < c.circle_radius + 0.1) {
        const Vec2 back = s.ball + (stance.position - s.ball).normalized() * c.circle_radius;
        return walk_to(s.self, {back, stance.yaw}, robots, c);
    }
    motion::Walk walk = walk_to(s.self, stance, robots, c);
    // The last centimetres at a speed that steps can make, or they take for ever.
    const double speed = std::hypot(walk.forward, walk.left);
    if (speed > 1e-6 && speed < c.approach_speed && error.worst > 1.0) {
        walk.forward *= c.approach_speed / speed;
        walk.left *= c.approach_speed / speed;
    }
    return walk;
}

}  // namespace k3d::agent::skills
