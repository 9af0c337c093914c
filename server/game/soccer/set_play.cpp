// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/soccer/set_play.h"

#include <cmath>

#include "server/game/clearing.h"
#include "server/game/soccer/drop_ball.h"
#include "server/game/soccer/kick_taker.h"
#include "server/game/soccer/observe.h"

namespace k3d::server::game {

namespace {

Area penalty_area(wire::Side side) {
    constexpr double kGoalLine = field::kLength / 2.0;
    constexpr double kFront = kGoalLine - field::kPenaltyLength;
    constexpr double kY = field::kPenaltyWidth / 2.0;
    return side == wire::Side::Left ? Area{-kGoalLine, -kFront, -kY, kY}
                                    : Area{kFront, kGoalLine, -kY, kY};
}

bool out_of_penalty_area(const Vec3& ball, wire::Side side) {
    if (!on_field(ball)) return true;
    const Area area = penalty_area(side);
    const bool in_front = side == wire::Side::Left ? ball.x() > area.max_x : ball.x() < area.min_x;
    return in_front || ball.y() < area.min_y || ball.y() > area.max_y;
}

/// Free kicks inside a penalty area are taken from its corner.
void move_spot_out_of_penalty_areas(Vec3& spot) {
    for (const wire::Side side : {wire::Side::Left, wire::Side::Right}) {
        const Area area = penalty_area(side);
        if (!area.contains(spot.head<2>())) continue;
        spot.x() = side == wire::Side::Left ? area.max_x : area.min_x;
        spot.y() = spot.y() < 0.0 ? area.min_y : area.max_y;
    }
}

/// The ball lies on its spot; at first the kicking team is moved off it.
void hold_ball(Match& match, wire::Side kicking) {
    if (!match.memory.kick_prepared) {
        repel(match.scene, match.memory.kick_spot, kKickRepelDistance, 0.0, kicking);
        match.memory.kick_prepared = true;
        match.memory.last_touch.reset();  // touches before the ball lay there were none of the kick
    }
    match.place_ball(match.memory.kick_spot);
}

}  // namespace

void set_play(Match& match, PlayMode left_one, wire::Side kicking) {
    if (match.state.mode_time < kKickInPause) return;
    forget_kicks(match);
    const bool free_kick =
        left_one == PlayMode::FreeKickLeft || left_one == PlayMode::DirectFreeKickLeft;
    if (free_kick) move_spot_out_of_penalty_areas(match.memory.kick_spot);
    clear_circle(match.scene, match.memory.kick_spot, kFreeKickDistance, opponent(kicking));
    if (match.state.mode_time > kDropBallTime) {
        drop_ball(match, match.memory.kick_spot);
    } else if (match.memory.kick_prepared && match.touched_since(kKickInPause)) {
        const bool direct =
            left_one == PlayMode::CornerKickLeft || left_one == PlayMode::DirectFreeKickLeft;
        note_kick(match, !direct);
        match.enter(PlayMode::PlayOn);
    } else {
        hold_ball(match, kicking);
    }
}

void goal_kick(Match& match) {
    if (match.state.mode_time < kKickInPause) return;
    const wire::Side kicking = side_in(match.state.mode, PlayMode::GoalKickLeft);
    forget_kicks(match);
    clear_area(match.scene, penalty_area(kicking), opponent(kicking));
    if (match.state.mode_time > kDropBallTime) {
        drop_ball(match, match.memory.kick_spot);
    } else if (!match.memory.kick_prepared || !match.touched_since(kKickInPause)) {
        hold_ball(match, kicking);
    } else if (out_of_penalty_area(match.scene.ball.position(), kicking)) {
        note_kick(match, false);
        match.enter(PlayMode::PlayOn);
    }
}

}  // namespace k3d::server::game
