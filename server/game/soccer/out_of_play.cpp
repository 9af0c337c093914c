// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/soccer/out_of_play.h"

#include <cmath>

#include "server/game/soccer/observe.h"

namespace k3d::server::game {

void award_kick_in(Match& match, wire::Side team) {
    const Vec3 left_at = match.memory.last_ball_on_field;
    match.memory.kick_spot = {
        left_at.x(), std::copysign(field::kWidth / 2.0 - field::kBallRadius, left_at.y()),
        field::kBallRadius};
    match.enter(mode_for(PlayMode::KickInLeft, team));
}

void award_corner_kick(Match& match, wire::Side team) {
    // The league takes corner kicks half way between corner and goal post.
    constexpr double kY = (field::kWidth + field::kGoalWidth) / 4.0 - field::kBallRadius;
    const double x = field::kLength / 2.0 - field::kBallRadius;
    match.memory.kick_spot = {team == wire::Side::Left ? x : -x,
                              std::copysign(kY, match.scene.ball.position().y()),
                              field::kBallRadius};
    match.enter(mode_for(PlayMode::CornerKickLeft, team));
}

void award_goal_kick(Match& match, wire::Side team) {
    const double x = field::kLength / 2.0 - kGoalKickDistance;
    match.memory.kick_spot = {team == wire::Side::Left ? -x : x, 0.0, field::kBallRadius};
    match.enter(mode_for(PlayMode::GoalKickLeft, team));
}

bool ball_out(Match& match) {
    const Vec3 ball = match.scene.ball.position();
    if (on_field(ball)) return false;
    // A ball that a trainer has put outside belongs to nobody.
    if (!match.memory.last_touch) return false;
    const wire::Side touched = match.memory.last_touch->team;
    const wire::Side side_of_ball = ball.x() < 0.0 ? wire::Side::Left : wire::Side::Right;
    if (std::abs(ball.x()) < field::kLength / 2.0) {
        award_kick_in(match, opponent(touched));
    } else if (touched == side_of_ball) {
        award_corner_kick(match, opponent(touched));
    } else {
        award_goal_kick(match, side_of_ball);
    }
    return true;
}

}  // namespace k3d::server::game
