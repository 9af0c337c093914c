// SPDX-License-Identifier: BSD-3-Clause
#include "agent/motion/walk/walk_engine.h"

#include <algorithm>
#include <cmath>

#include "common/clock/clock.h"

namespace k3d::agent::motion::walk {

namespace {

using nao::JointId;

constexpr double kFullSlipSpeed = 0.15;     // m/s, about which feet begin to slip fully
constexpr double kStoppedDistance = 0.012;  // m, feet this close to the stance may just stand
constexpr double kSteady = 0.08;            // rad, tilt error below which walking may stop
constexpr double kMaxError = 0.5;           // rad, beyond it the robot falls whatever is done
constexpr double kMaxHeadingError = 0.25;   // rad
constexpr double kMaxLandingShift = 0.08;   // m

double approach(double value, double target, double step) {
    return value + std::clamp(target - value, -step, step);
}

double length_of_leg(const kinematics::Leg& leg) {
    return leg.hip().z() - leg.zero_pose().position.z();
}

/// The values as this type of robot walks with them.
Config of_type(Config config, int type) {
    config.step_duration *= config.type_step_duration[static_cast<std::size_t>(type)];
    return config;
}

bool is_zero(const Walk& v) {
    return v.forward == 0.0 && v.left == 0.0 && v.turn == 0.0;
}

}  // namespace

WalkEngine::WalkEngine(const nao::Model& model, const Config& config)
    : config_(of_type(config, model.type)),
      right_(model, Side::Right),
      left_(model, Side::Left),
      hips_(left_.hip().x(), 0.0, left_.hip().z()),
      leg_length_(length_of_leg(left_)),
      scale_(leg_length_ / length_of_leg(kinematics::Leg(nao::model(0), Side::Left))),
      share_(config.type_speed[static_cast<std::size_t>(model.type)]),
      steps_(config_, left_.hip().y(), scale_) {}

void WalkEngine::start(const Walk& wish) {
    velocity_ = {};
    heading_error_ = 0.0;
    // A sideways walk or turn begins with the foot of that side, which opens the stance.
    const bool left_first = wish.left + 0.1 * wish.turn >= 0.0;
    steps_.start(left_first ? Side::Left : Side::Right);
    moving_ = true;
}

void WalkEngine::abandon() {
    velocity_ = {};
    moving_ = false;
}

void WalkEngine::follow(const Walk& wish) {
    const auto of_top = [this](double speed, double limit) {
        return std::abs(speed) / std::max(limit * share_, 1e-6);
    };
    // All three at their limit at once would be too much for the legs.
    const double top = wish.forward >= 0.0 ? config_.max_forward : config_.max_backward;
    const double p = wish.brisk ? config_.brisk_combined : config_.combined;
    const double load = std::pow(std::pow(of_top(wish.forward, top), p) +
                                     std::pow(of_top(wish.left, config_.max_sideways), p) +
                                     std::pow(of_top(wish.turn, config_.max_turn), p),
                                 1.0 / p);
    const double allowed = load > 1.0 ? 1.0 / load : 1.0;
    const auto follow_one = [&](double& value, double wanted, double acceleration) {
        value = approach(value, wanted * allowed, acceleration * share_ * kCycleSeconds);
    };
    const bool braking = velocity_.forward * (wish.forward * allowed - velocity_.forward) < 0.0;
    follow_one(velocity_.forward, wish.forward,
               braking ? config_.braking : config_.forward_acceleration);
    follow_one(velocity_.left, wish.left, config_.sideways_acceleration);
    follow_one(velocity_.turn, wish.turn, config_.turn_acceleration);
}

Walk WalkEngine::steered(const Posture& posture) {
    // Feet slip, most of all in turns; the gyro tells how far the robot has really turned.
    const double turned = posture.rate.dot(posture.up);
    heading_error_ = std::clamp(heading_error_ + (velocity_.turn - turned) * kCycleSeconds,
                                -kMaxHeadingError, kMaxHeadingError);
    if (is_zero(velocity_)) heading_error_ = 0.0;  // coming to a stop: no more turning
    Walk velocity = velocity_;
    velocity.forward = forward_steps(velocity.forward);
    velocity.left *= config_.sideways_scale;
    velocity.turn = velocity.turn * config_.turn_scale + config_.heading_gain * heading_error_;
    return velocity;
}

/// Feet lose about the same speed to slipping at any but the slowest walk forward.
double WalkEngine::forward_steps(double speed) const {
    const double scaled = config_.forward_scale * speed;
    if (speed <= 0.0) return scaled;
    const double slip = config_.forward_slip * (1.0 - std::exp(-speed / kFullSlipSpeed));
    return std::max(std::min(scaled + slip, config_.max_forward * share_), scaled);
}

void WalkEngine::balance(const Posture& posture) {
    const auto limited = [](double error) { return std::clamp(error, -kMaxError, kMaxError); };
    pitch_now_ = limited(posture.pitch - lean());
    roll_now_ = limited(posture.roll);
    pitch_rate_ = posture.rate.y();
    roll_rate_ = posture.rate.x();
    pitch_error_ = limited(pitch_now_ + config_.pitch_lead * pitch_rate_);
    roll_error_ = limited(roll_now_ + config_.roll_lead * roll_rate_);
}

Correction WalkEngine::landing_shift() const {
    const auto limited = [](double shift) {
        return std::clamp(shift, -kMaxLandingShift, kMaxLandingShift);
    };
    // Leaning right is positive roll, and asks for a step to the right.
    return {limited(config_.step_forward * pitch_now_ + config_.step_forward_rate * pitch_rate_),
            limited(-config_.step_sideways * roll_now_ - config_.step_sideways_rate * roll_rate_)};
}

bool WalkEngine::step(const BodySense&, const Posture& posture, const Walk& wish,
                      JointTargets& out) {
    if (!moving_ && is_zero(wish)) {
        stance(out);
        return false;
    }
    if (!moving_) start(wish);
    follow(wish);
    balance(posture);
    steps_.advance(steered(posture), landing_shift());
    const bool steady = std::max(std::abs(pitch_now_), std::abs(roll_now_)) < kSteady;
    if (is_zero(wish) && is_zero(velocity_) && steps_.stepped() && steady &&
        steps_.distance_from_stance() < kStoppedDistance * scale_) {
        moving_ = false;
    }
    place_leg(Side::Right, steps_.foot(Side::Right), out);
    place_leg(Side::Left, steps_.foot(Side::Left), out);
    // Positive shoulder pitch lifts the arm forward; an arm swings against its own side's foot.
    const auto arm = [this](Side side) {
        return -config_.arm_swing * steps_.foot(side).ground.position.x();
    };
    place_arms(arm(Side::Right), arm(Side::Left), out);
    return moving_;
}

void WalkEngine::place_leg(Side side, const Foot& foot, JointTargets& out) const {
    const double air = foot.air;
    const auto mixed = [air](double support, double swing) {
        return support + air * (swing - support);
    };
    // Sole in the walk frame, from the hips.
    const double height = leg_length_ - config_.crouch * scale_;
    const Vec3 sole(foot.ground.position.x(),
                    foot.ground.position.y() - config_.sway * scale_ * steps_.sway(),
                    foot.lift - height);
    // The wanted lean, and the shares of the tilt error that swing the leg and turn the foot.
    const Mat3 swing =
        about_y(-lean() - mixed(config_.support_pitch, config_.swing_pitch) * pitch_error_) *
        about_x(-mixed(config_.support_roll, config_.swing_roll) * roll_error_);
    const Mat3 turn =
        about_y(-lean() -
                mixed(config_.support_turn_pitch, config_.swing_turn_pitch) * pitch_error_ +
                air * config_.toe_up) *
        about_x(-mixed(config_.support_turn_roll, config_.swing_turn_roll) * roll_error_);
    kinematics::SolePose target;
    target.position = hips_ + swing * sole;
    target.rotation = turn * about_z(foot.ground.yaw);
    const kinematics::Leg& leg = side == Side::Right ? right_ : left_;
    leg.solve(target, out.angle);
}

void WalkEngine::place_arms(double right_swing, double left_swing, JointTargets& out) const {
    out[JointId::RShoulderPitch] = config_.shoulder_pitch + right_swing;
    out[JointId::LShoulderPitch] = config_.shoulder_pitch + left_swing;
    out[JointId::RShoulderYaw] = -config_.shoulder_yaw;
    out[JointId::LShoulderYaw] = config_.shoulder_yaw;
    out[JointId::RArmRoll] = config_.arm_roll;
    out[JointId::LArmRoll] = -config_.arm_roll;
    out[JointId::RElbow] = config_.elbow;
    out[JointId::LElbow] = -config_.elbow;
}

void WalkEngine::stance(JointTargets& out) const {
    const double height = leg_length_ - config_.crouch * scale_;
    for (const Side side : {Side::Right, Side::Left}) {
        const Pose2 ground = steps_.neutral(side, {});
        kinematics::SolePose target;
        const Mat3 lean = about_y(-config_.lean);
        target.position = hips_ + lean * Vec3(ground.position.x(), ground.position.y(), -height);
        target.rotation = lean;
        (side == Side::Right ? right_ : left_).solve(target, out.angle);
    }
    place_arms(0.0, 0.0, out);
}

}  // namespace k3d::agent::motion::walk
