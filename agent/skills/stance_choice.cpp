// SPDX-License-Identifier: BSD-3-Clause
// Times of the ways into the stances.
#include "agent/skills/stance_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace k3d::agent::skills {
namespace {

constexpr double kStopping = 0.4;        // s: steps to begin and to end a walk with
constexpr double kStepUpSpeed = 0.28;    // m/s, mean of small steps
constexpr double kStepUpWay = 0.4;       // m walked with small steps; what is beyond is walked fast
constexpr double kTurnRate = 1.6;        // rad/s, mean
constexpr double kRoundRate = 1.0;       // rad/s round the ball, mean of matches
constexpr double kPlaced = 0.02;         // m: as good as there
constexpr double kPlacedTurn = 0.2;      // rad

}  // namespace

KickGeometry no_farther(const KickGeometry& kick, double longest) {
    KickGeometry capped = kick;
    capped.suits = [=](int strike, double distance) {
        return kick.suits(strike, std::min(distance, longest));
    };
    capped.possible = [=](motion::Kick wish) {
        wish.distance = std::min(wish.distance, longest);
        return kick.possible(wish);
    };
    capped.reach = [=](double wanted) { return kick.reach(std::min(wanted, longest)); };
    return capped;
}

double time_to_stand(const Pose2& self, const Pose2& stance, const Vec2& ball,
                     const SkillConfig& c) {
    const double turn = std::abs(wrap_angle(stance.yaw - self.yaw));
    const double straight = (stance.position - self.position).norm();
    if (straight < kPlaced && turn < kPlacedTurn) return 0.0;
    const Vec2 from_ball = self.position - ball;
    const double around =
        std::abs(wrap_angle(yaw_of(stance.position - ball) - yaw_of(from_ball)));
    // Where the straight way would lead over the ball, there is one round it.
    const double away = std::max(from_ball.norm() - c.circle_radius, 0.0);
    const double steps = std::min(straight, kStepUpWay) / kStepUpSpeed +
                         std::max(straight - kStepUpWay, 0.0) / c.forward_speed;
    const double walking = std::max(steps, around / kRoundRate + away / c.forward_speed);
    return kStopping + std::max(walking, turn / kTurnRate);
}

Stance soonest_stance(const Pose2& self, const Vec2& ball, const Vec2& target, int kept,
                      const KickGeometry& kick, const SkillConfig& c) {
    const Vec2 shot = target - ball;
    Stance best;
    double least = std::numeric_limits<double>::infinity();
    for (int strike = 0; strike < kick.strikes; ++strike) {
        if (!kick.suits(strike, shot.norm())) continue;
        const Pose2 pose = kick.stand_pose(strike, ball, yaw_of(shot));
        const double time = time_to_stand(self, pose, ball, c);
        const double weighed = time - (strike == kept ? c.strike_keep_s : 0.0);
        if (weighed >= least) continue;
        least = weighed;
        best = {strike, pose, time};
    }
    return best;
}

}  // namespace k3d::agent::skills
