// SPDX-License-Identifier: BSD-3-Clause
// Steering: from pose and goal to walk velocities.
#include "agent/skills/go_to.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace k3d::agent::skills {
namespace {

constexpr double kTurnFirst = radians(60.0);  // beyond this error of the heading only turn
constexpr int kHeadings = 24;                 // tried for a way, the first one straight ahead
constexpr double kBackwardWorth = 0.85;       // backwards the walk is less sure

double turn_towards(double angle, const SkillConfig& c) {
    return std::clamp(c.turn_gain * angle, -c.turn_rate, c.turn_rate);
}

/// The velocity (robot frame) shortened to the walk's reach, its direction kept.
Vec2 within_reach(const Vec2& velocity, const SkillConfig& c) {
    const double forward = velocity.x() >= 0.0 ? c.forward_speed : c.backward_speed;
    const double use = std::hypot(velocity.x() / forward, velocity.y() / c.side_speed);
    return use > 1.0 ? Vec2(velocity / use) : velocity;
}

/// 1 when turned as wanted, 0 from kTurnFirst on.
double share_while_turning(double error) {
    return std::max(std::cos(std::min(std::abs(error) / kTurnFirst, 1.0) * (kPi / 2.0)), 0.0);
}

/// Turn towards a point in the robot frame and walk, at most this fast.
motion::Walk head_for(const Vec2& point, double speed, const SkillConfig& c) {
    const double bearing = yaw_of(point);
    motion::Walk walk;
    walk.forward = speed * share_while_turning(bearing);
    walk.turn = turn_towards(bearing, c);
    return walk;
}

/// Seconds for a metre in this direction of the robot frame; the legs share their reach out.
double slowness(double bearing, const SkillConfig& c) {
    const double forward = std::cos(bearing);
    const double backward_speed = kBackwardWorth * c.backward_speed;
    return std::abs(forward) / (forward >= 0.0 ? c.forward_speed : backward_speed) +
           std::abs(std::sin(bearing)) / c.side_speed;
}

/// How far to turn for the way to `point`, and there to `final_turn` (both in the robot frame), so
/// that turning, walking and turning again take the least time.
double best_turn(const Vec2& point, double final_turn, const SkillConfig& c) {
    const double bearing = yaw_of(point);
    const double way = point.norm();
    double best = 0.0;
    double shortest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < kHeadings; ++k) {
        const double off = 2.0 * kPi * k / kHeadings;
        const double turn = wrap_angle(bearing - off);
        const double turning = std::abs(turn) + std::abs(wrap_angle(final_turn - turn));
        const double time = turning / c.turn_rate + way * slowness(off, c);
        if (time < shortest) {
            shortest = time;
            best = turn;
        }
    }
    return best;
}

/// Walk to a point in the robot frame with the heading that takes the least time.
motion::Walk walk_turned(const Vec2& point, double final_turn, double speed, bool brisk,
                         const SkillConfig& c) {
    const double turn = best_turn(point, final_turn, c);
    const Vec2 velocity =
        within_reach(speed * share_while_turning(turn) * point.normalized(), c);
    const double rate = brisk ? std::clamp(c.brisk_turn_gain * turn, -c.brisk_turn_rate,
                                           c.brisk_turn_rate)
                              : turn_towards(turn, c);
    return {velocity.x(), velocity.y(), rate, brisk};
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
        return walk_turned(local, wrap_angle(goal.yaw - self.yaw),
                           direct ? std::min(c.forward_speed, c.gain * left_to_go) : c.forward_speed,
                           left_to_go > c.brisk_distance, c);
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
