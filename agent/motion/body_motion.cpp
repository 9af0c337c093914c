// SPDX-License-Identifier: BSD-3-Clause
#include "agent/motion/body_motion.h"

#include <algorithm>
#include <cmath>

#include "agent/motion/head/head.h"
#include "common/clock/clock.h"

namespace k3d::agent::motion {

namespace {

bool is_neck(nao::JointId id) {
    return id == nao::JointId::HeadYaw || id == nao::JointId::HeadPitch;
}

}  // namespace

BodyMotion::BodyMotion(const nao::Model& model, const Config& config)
    : model_(model),
      config_(config),
      right_(model, kinematics::Side::Right),
      left_(model, kinematics::Side::Left),
      walk_(model, config_.walk),
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
    const Posture& posture = posture_.update(sense);
    BodyShape shape;
    shape.parts = kinematics::forward(model_, sense.joints);
    shape.right_sole = posture.torso * right_.sole(shape.parts).position;
    shape.left_sole = posture.torso * left_.sole(shape.parts).position;
    state_.odometry = odometry_.update(sense, shape, posture_.turned());
    state_.torso = posture.torso;
    state_.torso_height = -std::min(shape.right_sole.z(), shape.left_sole.z());
    const kinematics::PartPose& head = shape.parts[nao::index(nao::Part::Head)];
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
    const bool fallen = posture_.posture().up.z() < std::cos(config_.fallen_tilt);
    if (fallen && state_.upright) {
        state_.upright = false;
        ++state_.falls;
    }
    if (!fallen) state_.upright = true;
    if (!state_.upright) {
        fall(sense);
        return;
    }
    const Walk* wish = std::get_if<Walk>(&request.body);
    stand_or_walk(sense, wish != nullptr ? *wish : Walk{});
}

void BodyMotion::fall(const BodySense&) {
    state_.activity = Activity::Falling;
    in_stance_ = false;
}

void BodyMotion::stand_or_walk(const BodySense& sense, const Walk& wish) {
    if (!in_stance_) {
        state_.activity = Activity::Standing;
        take_up_stance();
        return;
    }
    const bool walking = walk_.step(sense, posture_.posture(), wish, targets_);
    state_.activity = walking ? Activity::Walking : Activity::Standing;
}

void BodyMotion::take_up_stance() {
    JointTargets stance = targets_;
    walk_.stance(stance);
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
