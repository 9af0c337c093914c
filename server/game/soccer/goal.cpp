// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/soccer/goal.h"

#include <cmath>

#include "server/game/soccer/kick_taker.h"
#include "server/game/soccer/out_of_play.h"
#include "server/game/soccer/pass_mode.h"

namespace k3d::server::game {

namespace {

/// The ball touches the box behind the goal line (reference 6.4).
bool in_goal_box(const Vec3& ball) {
    const Vec3 centre(std::copysign(field::kLength / 2.0 + field::kGoalDepth / 2.0, ball.x()), 0.0,
                      field::kGoalHeight / 2.0);
    const Vec3 half(0.258, 1.008, field::kGoalHeight / 2.0);
    const Vec3 beyond = ((ball - centre).cwiseAbs() - half).cwiseMax(0.0);
    return beyond.norm() < field::kBallRadius;
}

/// In the last step the whole ball went over the goal line, between the posts.
bool crossed_goal_line(const Vec3& before, const Vec3& ball) {
    constexpr double kLine = field::kLength / 2.0 + field::kBallRadius;
    const double line = std::copysign(kLine, ball.x());
    if (std::abs(ball.x()) < kLine || std::abs(before.x()) >= kLine) return false;
    const Vec3 at = before + (ball - before) * ((line - before.x()) / (ball.x() - before.x()));
    return std::abs(at.y()) < field::kGoalWidth / 2.0 && at.z() < field::kGoalHeight;
}

/// No goal: what follows instead, `conceding` being whose goal it is.
void deny(Match& match, wire::Side kicking, wire::Side conceding) {
    if (kicking == conceding) {
        award_corner_kick(match, opponent(kicking));
    } else {
        award_goal_kick(match, conceding);
    }
}

}  // namespace

bool goal_scored(Match& match) {
    const Vec3 ball = match.scene.ball.position();
    if (!in_goal_box(ball) && !crossed_goal_line(match.memory.ball_before, ball)) return false;
    const wire::Side conceding = ball.x() < 0.0 ? wire::Side::Left : wire::Side::Right;
    const wire::Side scoring = opponent(conceding);
    if (match.memory.barred == scoring) {
        deny(match, scoring, conceding);
    } else if (straight_from_kick(match) &&
               (match.memory.indirect || match.memory.kicker->team == conceding)) {
        deny(match, match.memory.kicker->team, conceding);
    } else if (!may_score(match, scoring)) {
        award_goal_kick(match, conceding);
    } else {
        ++(scoring == wire::Side::Left ? match.state.score_left : match.state.score_right);
        match.enter(mode_for(PlayMode::GoalLeft, scoring));
    }
    return true;
}

}  // namespace k3d::server::game
