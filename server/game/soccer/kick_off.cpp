// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/soccer/kick_off.h"

#include "server/game/clearing.h"
#include "server/game/soccer/drop_ball.h"
#include "server/game/soccer/kick_taker.h"

namespace k3d::server::game {

namespace {

const Vec3 kCentreSpot(0.0, 0.0, field::kBallRadius);
/// With fewer players this is training, in which the kicker may do as it likes.
constexpr std::size_t kMinPlayersForRules = 3;

/// The half that `team` may not enter, wide enough to leave no way round.
Area forbidden_half(wire::Side team) {
    const double far_x = field::kLength / 2.0 + 10.0;
    const double y = field::kWidth / 2.0 + 10.0;
    return team == wire::Side::Left ? Area{0.0, far_x, -y, y} : Area{-far_x, 0.0, -y, y};
}

void clear_for_kick_off(Match& match, wire::Side kicking) {
    const wire::Side other = opponent(kicking);
    clear_area(match.scene, forbidden_half(other), other);
    clear_circle(match.scene, kCentreSpot, kFreeKickDistance, other);
    clear_area(match.scene, forbidden_half(kicking), kicking, field::kCentreRadius);
}

}  // namespace

PlayMode kick_off_mode(const GameState& state, wire::Side side) {
    if (side == wire::Side::None) side = state.half == 1 ? wire::Side::Left : wire::Side::Right;
    return mode_for(PlayMode::KickOffLeft, side);
}

void before_kick_off(Match& match) {
    if (match.scene.players.empty()) return;
    match.place_ball(kCentreSpot);
    if (!match.config.referee) return;
    for (const wire::Side team : {wire::Side::Left, wire::Side::Right}) {
        clear_area(match.scene, forbidden_half(team), team);
    }
    if (match.config.automatic_kick_off && match.state.mode_time >= match.config.kick_off_wait) {
        match.enter(kick_off_mode(match.state, wire::Side::None));
    }
}

void kick_off(Match& match) {
    const wire::Side kicking = side_in(match.state.mode, PlayMode::KickOffLeft);
    forget_kicks(match);
    if (match.config.referee) clear_for_kick_off(match, kicking);
    if (match.touched_since(0.0)) {
        if (match.scene.players.size() >= kMinPlayersForRules) {
            note_kick(match, true);
            match.memory.barred = match.memory.last_touch->team;
        }
        match.enter(PlayMode::PlayOn);
    } else if (match.state.mode_time > kDropBallTime) {
        drop_ball(match, match.scene.ball.position());
    }
}

void after_goal(Match& match) {
    const wire::Side next = opponent(side_in(match.state.mode, PlayMode::GoalLeft));
    if (match.config.referee) clear_for_kick_off(match, next);
    if (match.state.mode_time < kGoalPause) return;
    match.place_ball(kCentreSpot);
    match.enter(kick_off_mode(match.state, next));
}

void lift_bar(Match& match) {
    const wire::Side barred = match.memory.barred;
    if (barred == wire::Side::None) return;
    const bool outside = match.scene.ball.position().head<2>().norm() > field::kCentreRadius;
    if (match.touches(opponent(barred)) || (match.touches(barred) && outside)) {
        match.memory.barred = wire::Side::None;
    }
}

}  // namespace k3d::server::game
