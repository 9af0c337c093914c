// SPDX-License-Identifier: BSD-3-Clause
// One cycle of the body: senses and a request in, joint speeds and the body's state out. Chooses
// between standing, walking, kicking and getting up.
//
// Agent axes x forward, y left, z up; rad, m, s.
#pragma once

#include "agent/motion/config.h"
#include "agent/motion/getup/get_up.h"
#include "agent/motion/joint_control.h"
#include "agent/motion/kick/kick_engine.h"
#include "agent/motion/motion.h"
#include "agent/motion/odometry.h"
#include "agent/motion/posture.h"
#include "agent/motion/walk/walk_engine.h"

namespace k3d::agent::motion {

class BodyMotion {
  public:
    BodyMotion(const nao::Model& model, const Config& config);
    BodyMotion(const BodyMotion&) = delete;  // engines refer to config_
    BodyMotion& operator=(const BodyMotion&) = delete;

    /// Both exactly once per percept frame, in this order: sense() says where camera and torso are
    /// in this frame and how far the robot went; act() chooses, and `rates` (rad/s) is the reply.
    /// Activity, falls and kick events are those of the act() before until act() is called.
    const State& sense(const BodySense& sense);
    const State& act(const BodySense& sense, const Request& request, nao::JointArray& rates);
    /// The two in one, for requests that do not depend on this frame.
    const State& step(const BodySense& sense, const Request& request, nao::JointArray& rates);

    const State& state() const { return state_; }
    const Posture& posture() const { return posture_.posture(); }
    const kick::Config& kick_config() const { return config_.kick; }  ///< of this type of robot

  private:
    void choose(const BodySense& sense, const Request& request);
    void notice_fall();
    void fall_and_get_up(const BodySense& sense);
    bool kick(const BodySense& sense, const Request& request);
    void stand_or_walk(const BodySense& sense, const Walk& wish);
    void topple(const Topple& wish);
    void take_up_stance();
    nao::JointArray stance() const;

    const nao::Model& model_;
    const Config config_;
    kinematics::Leg right_, left_;
    PostureFilter posture_;
    Odometry odometry_;
    walk::WalkEngine walk_;
    kick::KickEngine kick_;
    getup::GetUp get_up_;
    JointControl control_;
    JointTargets targets_;
    State state_;
    bool in_stance_ = false;  ///< legs have the walk's stance, or the walk has them
    bool started_ = false;
    double time_ = 0.0;         ///< s, of this cycle
    double stood_since_ = 0.0;  ///< s, start of the running time in the stance
    double fell_at_ = 0.0;      ///< s, of the running fall
};

}  // namespace k3d::agent::motion
