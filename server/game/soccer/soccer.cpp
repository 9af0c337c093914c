// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/soccer/soccer.h"

#include <cmath>

#include "common/field/field.h"

namespace k3d::server::game {

namespace {

constexpr double kDropBallTime = 15.0;   // s without a touch after kick-off
constexpr double kGoalPause = 3.0;       // s
const Vec3 kCentreSpot(0.0, 0.0, field::kBallRadius);

void centre_ball(body::Scene& scene) {
    scene.ball.move(kCentreSpot);
    scene.ball.set_velocity(Vec3::Zero());
}

bool is_goal(PlayMode mode) { return mode == PlayMode::GoalLeft || mode == PlayMode::GoalRight; }
bool is_kick_off(PlayMode mode) {
    return mode == PlayMode::KickOffLeft || mode == PlayMode::KickOffRight;
}

}  // namespace

Vec3 Soccer::start_slot(wire::Side team, int unum) {
    // Slots go down the left edge 1.2 m apart; a full column moves on by 0.8 m (reference 1.6).
    constexpr double kTop = field::kWidth / 2.0 - 0.8;
    constexpr int kPerColumn = 1 + static_cast<int>((kTop + field::kWidth / 2.0) / 1.2);
    const int slot = unum - 1;
    const double x = (team == wire::Side::Left ? -field::kLength / 2.0 + 0.8
                                               : field::kLength / 2.0 - 0.8) +
                     0.8 * (slot / kPerColumn);
    return {x, kTop - 1.2 * (slot % kPerColumn), field::kAgentRadius};
}

bool Soccer::beam_allowed() const {
    return state_.mode == PlayMode::BeforeKickOff || is_goal(state_.mode);
}

void Soccer::kick_off(wire::Side side) {
    const bool left = side == wire::Side::Left || (side == wire::Side::None && state_.half == 1);
    state_.enter(left ? PlayMode::KickOffLeft : PlayMode::KickOffRight);
}

void Soccer::keep_own_halves(body::Scene& scene, wire::Side kicking) {
    for (const auto& player : scene.players) {
        if (player->team == wire::Side::None || player->team == kicking) continue;
        const double own = player->team == wire::Side::Left ? -1.0 : 1.0;
        Vec3 torso = player->robot->torso_position();
        const bool wrong_half = torso.x() * own < 0.0;
        const bool in_circle = kicking != wire::Side::None &&
                               torso.head<2>().norm() < field::kCentreRadius;
        if (!wrong_half && !in_circle) continue;
        torso.x() = own * (in_circle ? field::kCentreRadius + 0.5 : field::kAgentRadius);
        player->robot->move(torso);
    }
}

void Soccer::before_step(body::Scene& scene) {
    if (state_.mode == PlayMode::BeforeKickOff) {
        if (!scene.players.empty()) centre_ball(scene);
        keep_own_halves(scene, wire::Side::None);
    } else if (is_kick_off(state_.mode)) {
        keep_own_halves(scene, state_.mode == PlayMode::KickOffLeft ? wire::Side::Left
                                                                    : wire::Side::Right);
    }
}

void Soccer::after_step(body::Scene& scene) {
    state_.advance();
    if (is_kick_off(state_.mode)) {
        const bool touched = !ball_touchers(scene.world.contacts()).empty();
        if (touched || state_.mode_time > kDropBallTime) state_.enter(PlayMode::PlayOn);
    } else if (is_goal(state_.mode) && state_.mode_time >= kGoalPause) {
        const bool left_scored = state_.mode == PlayMode::GoalLeft;
        centre_ball(scene);
        kick_off(left_scored ? wire::Side::Right : wire::Side::Left);
    } else if (state_.mode == PlayMode::PlayOn) {
        check_goal(scene);
    }
    if (state_.half == 1 && state_.time >= config_.half_time) {
        state_.half = 2;
        state_.enter(PlayMode::BeforeKickOff);
    } else if (state_.half == 2 && state_.time >= 2.0 * config_.half_time && !over()) {
        state_.enter(PlayMode::GameOver);
    }
}

void Soccer::check_goal(body::Scene& scene) {
    const Vec3 ball = scene.ball.position();
    if (std::abs(ball.x()) <= field::kLength / 2.0 + field::kBallRadius) return;
    if (std::abs(ball.y()) >= field::kGoalWidth / 2.0 || ball.z() >= field::kGoalHeight) return;
    const bool left_scored = ball.x() > 0.0;
    ++(left_scored ? state_.score_left : state_.score_right);
    state_.enter(left_scored ? PlayMode::GoalLeft : PlayMode::GoalRight);
}

}  // namespace k3d::server::game
