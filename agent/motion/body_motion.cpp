// SPDX-License-Identifier: BSD-3-Clause
#include "agent/motion/body_motion.h"

#include <algorithm>
#include <cmath>

#include "agent/motion/head/head.h"
#include "common/clock/clock.h"

namespace k3d::agent::motion {

namespace {

/// The values as this type of robot moves with them.
Config of_type(Config config, int type) {
    config.kick = kick_of_type(config.kick, config.kick_by_type, type);
    return config;
}

bool is_neck(nao::JointId id) {
    return id == nao::JointId::HeadYaw || id == nao::JointId::HeadPitch;
}

}  // namespace

BodyMotion::BodyMotion(const nao::Model& model, const Config& config)
    : model_(model),
      config_(of_type(config, model.type)),
      right_(model, kinematics::Side::Right),
      left_(model, kinematics::Side::Left),
      walk_(model, config_.walk),
      kick_(config_.kick),
      get_up_(config_.getup, model.type),
      control_(model) {}

const State& BodyMotion::step(const BodySense& sense, const Request& request,
                              nao::JointArray& rates) {
    this->sense(sense);
    return act(sense, request, rates);
}

const State& BodyMotion::act(const BodySense& sense, const Request& request,
                             nao::JointArray& rates) {
    choose(sense, request);
    head::look(request.head, posture_.posture(), targets_);
    control_.step(sense.joints, targets_, rates);
    return state_;
}

const State& BodyMotion::sense(const BodySense& sense) {
    time_ = sense.time;
    const Posture& posture = posture_.update(sense);
    const kinematics::PartPoses parts = kinematics::forward(model_, sense.joints);
    const Soles soles{posture.torso * right_.sole(parts).position,
                      posture.torso * left_.sole(parts).position};
    state_.odometry = odometry_.update(sense, soles, posture_.turned());
    state_.odometry.position.x() *= config_.odometry_forward;
    state_.odometry.position.y() *= config_.odometry_sideways;
    state_.torso = posture.torso;
    state_.torso_height = -std::min(soles.right.z(), soles.left.z());
    const kinematics::PartPose& head = parts[nao::index(nao::Part::Head)];
    state_.camera = posture.torso * head.position + Vec3(0, 0, state_.torso_height);
    state_.camera_rotation = posture.torso * Quat(head.rotation);
    if (!started_) {
        targets_.angle = sense.joints;
        started_ = true;
    }
    return state_;
}

void BodyMotion::choose(const BodySense& sense, const Request& request) {
    state_.kick_started = false;
    state_.kick_done = false;
    notice_fall();
    if (!state_.upright) {
        fall_and_get_up(sense);
        return;
    }
    if (kick(sense, request)) return;
    if (const Topple* wish = std::get_if<Topple>(&request.body)) {
        topple(*wish);
        return;
    }
    const Walk* wish = std::get_if<Walk>(&request.body);
    stand_or_walk(sense, wish != nullptr ? *wish : Walk{});
}

void BodyMotion::notice_fall() {
    const bool tilted = posture_.posture().up.z() < std::cos(config_.fallen_tilt);
    if (!tilted || !state_.upright) return;
    state_.upright = false;
    ++state_.falls;
    state_.kick_done = state_.activity == Activity::Kicking;
    state_.activity = Activity::Falling;
    fell_at_ = time_;
    in_stance_ = false;
    walk_.abandon();
}

void BodyMotion::fall_and_get_up(const BodySense& sense) {
    if (state_.activity == Activity::Falling) {
        if (time_ - fell_at_ < config_.fall_s) return;  // the joints hold their pose
        get_up_.start(stance());
        state_.activity = Activity::GettingUp;
    }
    if (get_up_.step(sense, posture_.posture(), targets_)) return;
    state_.upright = true;
    state_.activity = Activity::Standing;
}

bool BodyMotion::kick(const BodySense& sense, const Request& request) {
    if (state_.activity != Activity::Kicking) {
        const Kick* wish = std::get_if<Kick>(&request.body);
        // A kick starts from quiet standing, to which stand_or_walk() brings the robot first. Begun
        // while the body still rocks from the last step, a quarter of the kicks end in a fall.
        if (wish == nullptr || !in_stance_ || state_.activity != Activity::Standing) return false;
        const double settle = wish->hurried ? config_.kick_hurry_s : config_.kick_settle_s;
        if (time_ - stood_since_ < settle) return false;
        if (!kick::kick_possible(config_.kick, *wish)) return false;
        kick_.start(*wish, stance());
        state_.activity = Activity::Kicking;
        state_.kick_started = true;
    }
    if (kick_.step(sense, posture_.posture(), targets_)) return true;
    state_.kick_done = true;
    state_.activity = Activity::Standing;
    in_stance_ = false;
    return true;
}

void BodyMotion::stand_or_walk(const BodySense& sense, const Walk& wish) {
    if (!in_stance_) {
        state_.activity = Activity::Standing;
        stood_since_ = time_;
        take_up_stance();
        return;
    }
    const bool walking = walk_.step(sense, posture_.posture(), wish, targets_);
    if (walking) stood_since_ = time_;
    state_.activity = walking ? Activity::Walking : Activity::Standing;
}

void BodyMotion::topple(const Topple& wish) {
    using enum nao::JointId;
    // A foot that pitches up tips the body forward over it; one that rolls, sideways.
    targets_[RAnklePitch] += wish.forward * kCycleSeconds;
    targets_[LAnklePitch] += wish.forward * kCycleSeconds;
    targets_[RAnkleRoll] += wish.left * kCycleSeconds;
    targets_[LAnkleRoll] += wish.left * kCycleSeconds;
    state_.activity = Activity::Standing;
    in_stance_ = false;
    walk_.abandon();
}

nao::JointArray BodyMotion::stance() const {
    JointTargets stance = targets_;
    walk_.stance(stance);
    return stance.angle;
}

void BodyMotion::take_up_stance() {
    const JointTargets stance{this->stance()};
    // All joints arrive together, so that the soles stay flat on the way down from straight legs.
    double farthest = 0.0;
    for (const nao::JointDef& joint : model_.joints) {
        if (is_neck(joint.id)) continue;
        farthest = std::max(farthest, std::abs(stance[joint.id] - targets_[joint.id]));
    }
    const double step = config_.stance_rate * kCycleSeconds;
    const double share = farthest > step ? step / farthest : 1.0;
    for (const nao::JointDef& joint : model_.joints) {
        if (is_neck(joint.id)) continue;
        targets_[joint.id] += share * (stance[joint.id] - targets_[joint.id]);
    }
    in_stance_ = share == 1.0;
}

}  // namespace k3d::agent::motion
