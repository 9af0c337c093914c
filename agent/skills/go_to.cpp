// SPDX-License-Identifier: BSD-3-Clause
// Steering: from pose and goal to walk velocities.
#include "agent/skills/go_to.h"

#include <algorithm>
#include <cmath>

namespace k3d::agent::skills {
namespace {

constexpr double kTurnFirst = radians(60.0);  // beyond this bearing turn before walking

double turn_towards(double angle, const SkillConfig& c) {
    return std::clamp(c.turn_gain * angle, -c.turn_rate, c.turn_rate);
}

/// The velocity (robot frame) shortened to the walk's reach, its direction kept.
Vec2 within_reach(const Vec2& velocity, const SkillConfig& c) {
    const double forward = velocity.x() >= 0.0 ? c.forward_speed : c.backward_speed;
    const double use = std::hypot(velocity.x() / forward, velocity.y() / c.side_speed);
    return use > 1.0 ? Vec2(velocity / use) : velocity;
}

/// Turn towards a point in the robot frame and walk, at most this fast.
motion::Walk head_for(const Vec2& point, double speed, const SkillConfig& c) {
    const double bearing = yaw_of(point);
    const double ahead = std::cos(std::min(std::abs(bearing) * (kPi / 2.0) / kTurnFirst, kPi / 2.0));
    motion::Walk walk;
    walk.forward = speed * std::max(ahead, 0.0);
    walk.turn = turn_towards(bearing, c);
    return walk;
}

}  // namespace

void robots_of(const world::Beliefs& b, double clearance, std::vector<Obstacle>& robots) {
    robots.clear();
    for (const auto& p : b.mates) robots.push_back({p.position, clearance});
    for (const auto& p : b.opponents) robots.push_back({p.position, clearance});
}

Vec2 waypoint(const Vec2& self, const Vec2& goal, std::span<const Obstacle> obstacles) {
    const Vec2 way = goal - self;
    const double length = way.norm();
    if (length < 1e-6) return goal;
    const Vec2 along = way / length;
    const Vec2 left(-along.y(), along.x());

    const Obstacle* nearest = nullptr;
    double nearest_ahead = length;
    for (const Obstacle& o : obstacles) {
        const Vec2 to = o.position - self;
        const double ahead = to.dot(along);
        const bool on_goal = (o.position - goal).norm() < o.clearance;
        const bool in_way = ahead > 0.0 && ahead < nearest_ahead &&
                            std::abs(to.dot(left)) < o.clearance;
        if (in_way && !on_goal) {
            nearest = &o;
            nearest_ahead = ahead;
        }
    }
    if (nearest == nullptr) return goal;

    // Pass on the side where it does not stand; exactly ahead counts as on the right.
    const Vec2 to = nearest->position - self;
    const double side = to.dot(left) > 0.0 ? -1.0 : 1.0;
    const double distance = to.norm();
    if (distance < nearest->clearance)  // too close already: slide by and away
        return self + (side * left - 0.5 * to / std::max(distance, 1e-6)).normalized();
    return nearest->position + side * left * (nearest->clearance * 1.1);
}

motion::Walk walk_to(const Pose2& self, const Pose2& goal, std::span<const Obstacle> obstacles,
                     const SkillConfig& c) {
    const Vec2 way = waypoint(self.position, goal.position, obstacles);
    const Vec2 local = self.to_local(way);
    const double left_to_go = (goal.position - self.position).norm();
    const bool direct = way == goal.position;
    if (left_to_go > c.near_distance || !direct)
        return head_for(local, direct ? std::min(c.forward_speed, c.gain * left_to_go) : c.forward_speed,
                        c);
    const Vec2 velocity = within_reach(c.gain * local, c);
    return {velocity.x(), velocity.y(), turn_towards(wrap_angle(goal.yaw - self.yaw), c)};
}

motion::Walk walk_onto(const Pose2& self, const Vec2& goal, std::span<const Obstacle> obstacles,
                       const SkillConfig& c) {
    return head_for(self.to_local(waypoint(self.position, goal, obstacles)), c.forward_speed, c);
}

motion::BodyRequest GoTo::step(const Pose2& self, const Pose2& goal,
                               std::span<const Obstacle> obstacles, const SkillConfig& c) {
    const double distance = (goal.position - self.position).norm();
    const double angle = std::abs(wrap_angle(goal.yaw - self.yaw));
    if (arrived_)
        arrived_ = distance < c.leave_distance && angle < c.leave_angle;
    else
        arrived_ = distance < c.arrive_distance && angle < c.arrive_angle;
    if (arrived_) return motion::Stand{};
    return walk_to(self, goal, obstacles, c);
}

}  // namespace k3d::agent::skills
