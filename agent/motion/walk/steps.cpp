// SPDX-License-Identifier: BSD-3-Clause
// Feet on the ground stay where they are while the torso moves; the swing foot goes from where it
// lifted to where it lands, as gently as swing_ease says; landing_match adds a share of the
// ground's speed at both ends (the tuned walk: none).
#include "agent/motion/walk/steps.h"

#include <algorithm>
#include <cmath>

#include "common/clock/clock.h"

namespace k3d::agent::motion::walk {

namespace {

/// Way of a swing foot, u = 0..1. `ease` 0 is the constant speed that spares the joints, 1 starts
/// and ends at rest; `slope` is the speed (per unit of u) added at both ends.
double swing_way(double from, double to, double slope, double ease, double u) {
    const double u2 = u * u;
    const double u3 = u2 * u;
    const double tangent = 2.0 * u3 - 3.0 * u2 + u;
    return from + (to - from) * (u + ease * (3.0 * u2 - 2.0 * u3 - u)) + slope * tangent;
}

Side other(Side side) {
    return side == Side::Right ? Side::Left : Side::Right;
}
double sign_of(Side side) {
    return side == Side::Left ? 1.0 : -1.0;
}

}  // namespace

Steps::Steps(const Config& config, double half_width, double scale)
    : config_(config), half_width_(half_width), scale_(scale) {
    start(Side::Left);
}

void Steps::start(Side first) {
    swing_ = first;
    phase_ = 0.0;
    in_air_ = false;
    stepped_ = true;
    for (const Side side : {Side::Right, Side::Left}) {
        feet_[static_cast<std::size_t>(side)] = {neutral(side, {}), 0.0, 0.0};
    }
}

Pose2 Steps::neutral(Side side, const Walk& velocity) const {
    // Turning opens the stance by half a step, since the hips can turn the legs outwards only;
    // walking sideways widens it, so that feet do not meet.
    const double ground_time =
        config_.step_duration * (2.0 - (config_.lift_end - config_.lift_start));
    const double wider = 0.25 * std::abs(velocity.left) * ground_time;
    const double open = 0.5 * std::abs(velocity.turn) * ground_time;
    const double s = sign_of(side);
    return {{config_.foot_forward * scale_ + config_.foot_forward_gain * velocity.forward,
             s * (half_width_ + config_.spread * scale_ + wider)},
            s * open};
}

void Steps::move_over_ground(Foot& foot, const Walk& velocity) const {
    const Pose2 torso{{velocity.forward * kCycleSeconds, velocity.left * kCycleSeconds},
                      velocity.turn * kCycleSeconds};
    foot.ground.position = torso.to_local(foot.ground.position);
    foot.ground.yaw -= torso.yaw;
    foot.lift = 0.0;
    foot.air = 0.0;
}

void Steps::swing_foot(const Walk& velocity, const Correction& correction) {
    Foot& foot = feet_[static_cast<std::size_t>(swing_)];
    const double air_share = config_.lift_end - config_.lift_start;
    // The last sample in the air lies short of the landing point and above the ground; from there
    // the foot is set down moving with the ground. Going all the way scuffs, and was slower.
    const double u = (phase_ - config_.lift_start) / air_share;
    if (u <= 0.0 || u >= 1.0) {
        in_air_ = false;
        move_over_ground(foot, velocity);
        return;
    }
    if (!in_air_) {
        in_air_ = true;
        lifted_from_ = foot.ground;
    }
    const double air_time = air_share * config_.step_duration;
    const double half_ground = 0.5 * config_.step_duration * (2.0 - air_share);
    Pose2 landing = neutral(swing_, velocity);
    landing.position += Vec2(velocity.forward * half_ground + correction.forward,
                             velocity.left * half_ground + correction.left);
    landing.yaw += velocity.turn * half_ground;
    // Never onto the other foot's side.
    const double inner = half_width_ - 0.012 * scale_;
    if (swing_ == Side::Left) {
        landing.position.y() = std::max(landing.position.y(), inner);
    } else {
        landing.position.y() = std::min(landing.position.y(), -inner);
    }
    const double match = -config_.landing_match * air_time;
    const auto way = [&](double from, double to, double speed) {
        return swing_way(from, to, match * speed, config_.swing_ease, u);
    };
    foot.ground.position = {way(lifted_from_.position.x(), landing.position.x(), velocity.forward),
                            way(lifted_from_.position.y(), landing.position.y(), velocity.left)};
    foot.ground.yaw = way(lifted_from_.yaw, landing.yaw, velocity.turn);
    foot.air = std::pow(std::sin(kPi * u), config_.lift_shape);
    foot.lift = foot.air *
                (config_.step_height + config_.step_height_gain * std::abs(velocity.forward)) *
                scale_;
}

void Steps::advance(const Walk& velocity, const Correction& correction) {
    phase_ += kCycleSeconds / config_.step_duration;
    stepped_ = phase_ >= 1.0;
    if (stepped_) {
        phase_ -= 1.0;
        swing_ = other(swing_);
        in_air_ = false;
    }
    move_over_ground(feet_[static_cast<std::size_t>(other(swing_))], velocity);
    swing_foot(velocity, correction);
}

double Steps::sway() const {
    const double side = swing_ == Side::Right ? 1.0 : -1.0;  // over the support foot
    return side * std::sin(kPi * phase_ + config_.sway_phase);
}

double Steps::distance_from_stance() const {
    double worst = 0.0;
    for (const Side side : {Side::Right, Side::Left}) {
        const Pose2 stance = neutral(side, {});
        const Foot& f = foot(side);
        worst = std::max({worst, (f.ground.position - stance.position).norm(),
                          0.1 * std::abs(f.ground.yaw - stance.yaw), f.lift});
    }
    return worst;
}

}  // namespace k3d::agent::motion::walk
