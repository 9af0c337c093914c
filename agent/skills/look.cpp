// SPDX-License-Identifier: BSD-3-Clause
// Head angles for tracking, sweeping and searching.
#include "agent/skills/look.h"

#include <algorithm>
#include <cmath>

#include "common/field/field.h"

namespace k3d::agent::skills {
namespace {

// The neck turns +-120 and nods +-45 degrees (reference 5.2); stay off the end stops.
constexpr double kMaxYaw = radians(110.0);
constexpr double kMinPitch = radians(-40.0);
constexpr double kMaxPitch = radians(20.0);
constexpr double kSearchPitch = radians(-20.0);
constexpr double kFacing = radians(40.0);
constexpr double kUnlocalisedSweep = radians(50.0);

double swing(double now, double period) { return std::sin(2.0 * kPi * now / period); }

}  // namespace

motion::HeadRequest look_at(const Vec2& point, double camera_height) {
    const double distance = std::max(point.norm(), 0.05);
    const double pitch = -std::atan2(camera_height - field::kBallRadius, distance);
    return {std::clamp(yaw_of(point), -kMaxYaw, kMaxYaw), std::clamp(pitch, kMinPitch, kMaxPitch)};
}

motion::HeadRequest look(const world::Beliefs& b, const motion::State& body, bool busy,
                         const SkillConfig& c) {
    const double unseen = b.now - b.ball.seen;
    if (!b.ball.known || unseen > c.look_lost_after)
        return {kMaxYaw * swing(b.now, c.look_period * 1.5), kSearchPitch};
    motion::HeadRequest head = look_at(b.self.pose.to_local(b.ball.position), body.camera.z());
    const double width =
        busy ? c.look_sweep_busy : (b.self.localised ? c.look_sweep : std::max(c.look_sweep, kUnlocalisedSweep));
    head.yaw = std::clamp(head.yaw + width * swing(b.now, c.look_period), -kMaxYaw, kMaxYaw);
    return head;
}

std::optional<motion::Walk> search_turn(const world::Beliefs& b, const SkillConfig& c) {
    if (b.now - b.ball.seen <= c.look_turn_after) return std::nullopt;
    double turn = 0.6 * c.turn_rate;
    if (b.ball.known) {  // heard of: face it; if it is not there after all, go on turning
        const double bearing = yaw_of(b.self.pose.to_local(b.ball.position));
        if (std::abs(bearing) > kFacing) turn = std::copysign(turn, bearing);
    }
    return motion::Walk{0.0, 0.0, turn};
}

}  // namespace k3d::agent::skills
