// SPDX-License-Identifier: BSD-3-Clause
#include "agent/world/ball_track.h"

#include "common/field/field.h"

namespace k3d::agent::world {

namespace {

constexpr double kBefore = 0.5;        // s, paper-notes: prev_ball
constexpr double kStale = 1.0;         // s without a measurement: a surprise starts anew
constexpr double kStartSpeedSd = 1.0;  // m/s
constexpr double kHeardSd = 0.2;       // m
constexpr double kHeardSpeedSd = 0.5;  // m/s
constexpr double kSignificance = 2.5;  // deviations of speed that make a motion

}  // namespace

BallTrack::BallTrack(const BallConfig& config)
    : config_(config), finish_(config.alpha, config.lambda) {}

void BallTrack::reset() {
    *this = BallTrack(config_);
}

bool BallTrack::known(double now) const {
    return now - heard_ < config_.memory && misses_ < config_.misses;
}

void BallTrack::predict(double now) {
    const double dt = now - now_;
    now_ = now;
    if (dt > 0.0 && dt < config_.memory) {
        filter_.predict(dt, field::kRollDecay,
                        moving_ ? config_.acceleration_sd : config_.rest_acceleration_sd);
        judge_motion();
    }
}

void BallTrack::start(const Vec2& position, double sd) {
    filter_.start(position, sd, Vec2::Zero(), kStartSpeedSd);
    finish_.reset();
    moving_ = false;
    for (Moment& moment : history_) moment.time = -1e9;
}

void BallTrack::see(const Vec2& position, double sd, double now) {
    const double since = now - measured_;
    const Vec2 jump = position - filter_.position();
    const bool surprised = filter_.surprise(position, sd) > config_.kick_gate;
    if (!known(now) || (surprised && since > kStale) ||
        (surprised && jump.norm() > config_.max_speed * since)) {
        start(position, sd);
    } else if (surprised) {
        filter_.disturb(config_.kick_speed_sd, since);
        filter_.measure(position, sd);
        finish_.reset();
    } else {
        filter_.measure(position, sd);
    }
    seen_ = heard_ = measured_ = now;
    misses_ = 0;
    judge_motion();
    finish_.add(position, now);
}

void BallTrack::hear(const Vec2& position, const Vec2& velocity, double now) {
    if (known(now) && now - seen_ < config_.hear_after) return;
    const bool fits = known(now) && filter_.surprise(position, kHeardSd) < config_.kick_gate;
    if (fits) {
        filter_.measure(position, kHeardSd);
    } else {
        start(position, kHeardSd);
        filter_.start(position, kHeardSd, velocity, kHeardSpeedSd);
        moving_ = velocity.norm() > config_.moving_speed;
    }
    heard_ = measured_ = now;
    misses_ = 0;
    judge_motion();
}

void BallTrack::miss() {
    ++misses_;
}

void BallTrack::reseat(const Pose2& from, const Pose2& to) {
    filter_.reseat(from, to);
    finish_.reset();
    for (Moment& moment : history_) moment.position = to.to_global(from.to_local(moment.position));
}

/// Hysteresis, and a speed must stand out from its own error to count as motion.
void BallTrack::judge_motion() {
    const double speed = filter_.velocity().norm();
    if (moving_) {
        moving_ = speed > config_.rest_speed;
    } else if (speed > config_.moving_speed && speed > kSignificance * filter_.velocity_sd()) {
        moving_ = true;
        finish_.reset();
    }
}

Vec2 BallTrack::position_before(double now) const {
    // The youngest moment at least kBefore old, else the oldest there is.
    const Moment* best = nullptr;
    for (const Moment& moment : history_) {
        if (moment.time < -1e8) continue;
        const bool old_enough = moment.time <= now - kBefore + 1e-6;
        if (best == nullptr) {
            best = &moment;
            continue;
        }
        const bool best_old_enough = best->time <= now - kBefore + 1e-6;
        if (old_enough != best_old_enough) {
            if (old_enough) best = &moment;
        } else if (old_enough ? moment.time > best->time : moment.time < best->time) {
            best = &moment;
        }
    }
    return best != nullptr ? best->position : filter_.position();
}

void BallTrack::report(double now, Ball& ball) {
    ball.known = known(now);
    ball.seen = seen_;
    if (!ball.known) {
        ball.velocity = Vec2::Zero();
        ball.finish = ball.position;
        ball.moving = false;
        return;
    }
    history_[next_] = {now, filter_.position()};
    next_ = (next_ + 1) % history_.size();
    ball.moving = moving_;
    ball.position = filter_.position();
    ball.velocity = moving_ ? filter_.velocity() : Vec2(Vec2::Zero());
    const Vec2 rolled_out = filter_.position() + filter_.velocity() / field::kRollDecay;
    ball.finish = moving_ ? finish_.estimate().value_or(rolled_out) : ball.position;
    ball.position_before = position_before(now);
}

}  // namespace k3d::agent::world
