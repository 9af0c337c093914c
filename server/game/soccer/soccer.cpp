// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/soccer/soccer.h"

#include <cmath>

#include "server/game/soccer/drop_ball.h"
#include "server/game/soccer/goal.h"
#include "server/game/soccer/half_time.h"
#include "server/game/soccer/kick_off.h"
#include "server/game/soccer/kick_taker.h"
#include "server/game/soccer/observe.h"
#include "server/game/soccer/out_of_play.h"
#include "server/game/soccer/pass_mode.h"
#include "server/game/soccer/set_play.h"

namespace k3d::server::game {

namespace {

void play_on(Match& match) {
    follow_passes(match);
    lift_bar(match);
    if (kicker_touched_twice(match)) return;
    if (goal_scored(match)) return;
    ball_out(match);
}

}  // namespace

void Soccer::after_step(body::Scene& scene) {
    state_.advance();
    if (aborted()) return;  // GameOver stays, and a broken scene cannot be judged
    Match match{config_, state_, scene, memory_};
    observe(match);
    if (config_.referee) end_half(match);
    judge(match);
    tell_score_wait(match);
    remember(match);
}

void Soccer::judge(Match& match) {
    const PlayMode mode = state_.mode;
    if (mode == PlayMode::BeforeKickOff) return before_kick_off(match);
    if (is_either(mode, PlayMode::KickOffLeft)) return game::kick_off(match);
    if (is_either(mode, PlayMode::GoalLeft)) return after_goal(match);
    if (!config_.referee) return;
    if (mode == PlayMode::PlayOn) return play_on(match);
    if (is_either(mode, PlayMode::PassLeft)) {
        pass_mode(match);
        return play_on(match);
    }
    if (is_either(mode, PlayMode::GoalKickLeft)) return goal_kick(match);
    for (const PlayMode left_one : {PlayMode::KickInLeft, PlayMode::CornerKickLeft,
                                    PlayMode::FreeKickLeft, PlayMode::DirectFreeKickLeft}) {
        if (is_either(mode, left_one)) return set_play(match, left_one, side_in(mode, left_one));
    }
    // Only a trainer calls offside; it is named after the team that is punished.
    if (is_either(mode, PlayMode::OffsideLeft)) {
        return set_play(match, PlayMode::FreeKickLeft, opponent(side_in(mode, PlayMode::OffsideLeft)));
    }
}

void Soccer::abort(episode::Status status, const std::string& reason) {
    if (over()) return;
    status_ = status;
    reason_ = reason;
    state_.enter(PlayMode::GameOver);
}

void Soccer::kick_off(wire::Side side) { state_.enter(kick_off_mode(state_, side)); }

void Soccer::drop_ball(body::Scene& scene) {
    Match match{config_, state_, scene, memory_};
    game::drop_ball(match, scene.ball.position());
}

void Soccer::pass(body::Scene& scene, const body::Player& player) {
    Match match{config_, state_, scene, memory_};
    if (config_.referee) ask_for_pass_mode(match, player);
}

Vec3 Soccer::next_start_slot(wire::Side team) {
    // Slots go down the edge 1.2 m apart; a full column moves on by 0.8 m (reference 1.6). The field is
    // as far as they go, however often a player leaves and comes back.
    constexpr double kTop = field::kWidth / 2.0 - 0.8;
    constexpr int kPerColumn = 1 + static_cast<int>((kTop + field::kWidth / 2.0) / 1.2);
    int& used = slots_used_[team == wire::Side::Left ? 0 : 1];
    const int slot = used;
    used = (used + 1) % (2 * kPerColumn);
    const double x = (team == wire::Side::Left ? -field::kLength / 2.0 + 0.8
                                               : field::kLength / 2.0 - 0.8) +
                     0.8 * (slot / kPerColumn);
    return {x, kTop - 1.2 * (slot % kPerColumn), field::kAgentRadius};
}

episode::Result Soccer::result() const {
    episode::Result result;
    result.game = "soccer";
    result.status = status_;
    result.reason = reason_;
    result.metrics = {{"time_s", std::round(state_.time * 50.0) / 50.0},
                      {"score_left", state_.score_left},
                      {"score_right", state_.score_right}};
    return result;
}

}  // namespace k3d::server::game
