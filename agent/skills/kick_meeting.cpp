// SPDX-License-Identifier: BSD-3-Clause
#include "agent/skills/kick_meeting.h"

#include <algorithm>
#include <cmath>

#include "agent/skills/intercept.h"
#include "common/field/field.h"

namespace k3d::agent::skills {
namespace {

constexpr double kPathStep = 0.02;      // m
constexpr double kReserve = 0.15;       // s to spare when a meeting is chosen
constexpr double kStepUpSpeed = 0.3;    // m/s, mean speed into a stance, turns and stop apart
constexpr double kStepUpTurn = 1.5;     // rad/s
constexpr double kStop = 0.5;           // s from the last step to quiet standing
constexpr double kOtherRoll = 0.5;      // m: the stopping point of another roll
constexpr double kEarly = 0.012;        // m that the ball may still have to come
constexpr double kReady = 1.3;          // tolerances within which a standing robot stays where it is

/// The ball's way from where it is to where it will rest.
struct Path {
    Vec2 finish;
    Vec2 along;    ///< unit vector
    double total;  ///< m

    Vec2 before_finish(double way) const { return finish - way * along; }
};

Path path_of(const world::Ball& ball) {
    const Vec2 way = ball.finish - ball.position;
    const double total = ball.moving ? way.norm() : 0.0;
    return {ball.finish, total > 1e-6 ? Vec2(way / total) : Vec2(Vec2::UnitX()), total};
}

}  // namespace

Meeting KickMeeting::plan(const Pose2& self, const world::Ball& ball, const Vec2& target,
                          bool may_kick, bool standing, const KickGeometry& kick,
                          const SkillConfig& c) {
    const Path path = path_of(ball);
    if (path.total < kPathStep || !may_kick) {
        before_finish_ = -1.0;
        const Vec2 rest = ball.moving ? ball.finish : ball.position;
        strike_ = soonest_stance(self, rest, target, strike_, kick, c).strike;
        return {strike_, rest, ball.position, true, false};
    }
    if (before_finish_ < 0.0 || (path.finish - finish_).norm() > kOtherRoll)
        before_finish_ = c.meet_before_finish;
    finish_ = path.finish;
    before_finish_ = std::min(before_finish_, path.total);

    strike_ = soonest_stance(self, path.before_finish(before_finish_), target, strike_, kick, c).strike;
    const auto stance_at = [&](double way) {
        const Vec2 point = path.before_finish(way);
        return kick.stand_pose(strike_, point, yaw_of(target - point));
    };
    // A robot that stands well already lets the ball come to its foot.
    const Pose2 stance = stance_at(before_finish_);
    const bool ready = standing && stance_error(self, stance, 0.0, c).worst < kReady;
    if (ready) {
        const Vec2 foot = self.to_global(stance.to_local(path.before_finish(before_finish_)));
        before_finish_ =
            std::clamp((path.finish - foot).dot(path.along), 0.0, c.meet_before_finish);
    }
    const auto in_time = [&](double way, double reserve) {
        const Pose2 place = stance_at(way);
        const double steps =
            std::max((place.position - self.position).norm() / kStepUpSpeed,
                     std::abs(wrap_angle(place.yaw - self.yaw)) / kStepUpTurn) + kStop;
        const double needed = c.kick_lead + (ready ? 0.0 : steps) + reserve;
        return roll_time(path.total - way, path.total) >= needed;
    };
    if (!in_time(before_finish_, -kReserve)) {
        while (before_finish_ > 0.0 && !in_time(before_finish_, kReserve))
            before_finish_ = std::max(0.0, before_finish_ - kPathStep);
    }

    const double rolled = path.total * (1.0 - std::exp(-field::kRollDecay * c.kick_lead));
    const double to_come = path.total - before_finish_ - rolled;
    const bool rolling = before_finish_ > kPathStep;
    return {strike_, path.before_finish(before_finish_), ball.position + rolled * path.along,
            !rolling || to_come < kEarly, rolling};
}

}  // namespace k3d::agent::skills
