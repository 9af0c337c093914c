// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/soccer/pass_mode.h"

#include "common/clock/clock.h"
#include "server/game/clearing.h"

namespace k3d::server::game {

namespace {

constexpr double kRepelPad = 0.1;  // m beyond the circle

double distance_to_ball(const Match& match, const body::Player& player) {
    const Vec3 ball = match.scene.ball.position();
    return (player.robot->torso_position() - ball).head<2>().norm();
}

bool barred_from_scoring(const PassUse& use, double now) {
    return use.last && now - *use.last < kPassScoreWait && !use.may_score;
}

}  // namespace

bool ask_for_pass_mode(Match& match, const body::Player& player) {
    if (match.state.mode != PlayMode::PlayOn || player.team == wire::Side::None) return false;
    const PassUse& use = match.pass_of(player.team);
    if (use.last && match.memory.now - *use.last < kPassRetryWait) return false;
    if (match.touches(player.team)) return false;
    if (match.scene.ball.velocity().norm() > kPassMaxBallSpeed) return false;
    if (distance_to_ball(match, player) > kPassMaxBallDistance) return false;
    for (const auto& other : match.scene.players) {
        if (other->team == opponent(player.team) &&
            distance_to_ball(match, *other) < kPassMinOpponentDistance) {
            return false;
        }
    }
    match.enter(mode_for(PlayMode::PassLeft, player.team));
    return true;
}

void pass_mode(Match& match) {
    const wire::Side team = side_in(match.state.mode, PlayMode::PassLeft);
    PassUse fresh;
    fresh.last = match.memory.now;
    fresh.ball = match.scene.ball.position();
    match.pass_of(team) = fresh;
    match.pass_of(opponent(team)).last.reset();
    if (match.state.mode_time >= kPassDuration || match.touched_since(0.0)) {
        match.enter(PlayMode::PlayOn);
    } else {
        repel(match.scene, match.scene.ball.position(), kPassMinOpponentDistance, kRepelPad,
              opponent(team));
    }
}

void follow_passes(Match& match) {
    for (const wire::Side team : {wire::Side::Left, wire::Side::Right}) {
        PassUse& use = match.pass_of(team);
        if (!barred_from_scoring(use, match.memory.now)) continue;
        const Vec3 moved = match.scene.ball.position() - use.ball;
        if (moved.head<2>().norm() >= kPassMinOpponentDistance) use.left_circle = true;
        for (const Touch& touch : match.memory.touching) {
            if (touch.team != team) continue;
            if (!use.toucher) use.toucher = touch.unum;
            if (*use.toucher != touch.unum && use.left_circle) use.may_score = true;
        }
    }
}

bool may_score(Match& match, wire::Side team) {
    return !barred_from_scoring(match.pass_of(team), match.memory.now);
}

void tell_score_wait(Match& match) {
    const auto wait = [&match](wire::Side team) {
        const PassUse& use = match.pass_of(team);
        const double now = match.memory.now;
        if (match.state.mode != PlayMode::PlayOn || !barred_from_scoring(use, now)) return 0.0;
        const double left = kPassScoreWait - (now - *use.last);
        return left > 0.5 * kCycleSeconds ? left : 0.0;  // less is what sums of 0.02 leave over
    };
    match.state.pass_wait_left = wait(wire::Side::Left);
    match.state.pass_wait_right = wait(wire::Side::Right);
}

}  // namespace k3d::server::game
