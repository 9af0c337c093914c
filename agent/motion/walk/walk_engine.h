// SPDX-License-Identifier: BSD-3-Clause
// The omnidirectional walk: a wanted velocity -> angles of legs and arms, cycle by cycle.
//
// Three parts: the velocity follows the wish within limits; Steps says where the feet shall be;
// balance turns legs and shifts landings by the torso's tilt error. Metres, radians, seconds.
#pragma once

#include "agent/motion/joint_targets.h"
#include "agent/motion/posture.h"
#include "agent/motion/walk/steps.h"

namespace k3d::agent::motion::walk {

class WalkEngine {
  public:
    WalkEngine(const nao::Model& model, const Config& config);

    /// The next step() begins to walk from a standstill in the stance.
    void start(const Walk& wish);
    /// The walk has ended without coming to a stop, as in a fall.
    void abandon();
    /// One cycle towards `wish`; zero means come to a stop. True while steps are made: false is
    /// returned from the cycle on in which both feet stand in the stance.
    bool step(const BodySense& sense, const Posture& posture, const Walk& wish, JointTargets& out);

    /// Legs and arms of the stance, in which the robot waits and from which it walks.
    void stance(JointTargets& out) const;

  private:
    void follow(const Walk& wish);
    Walk steered(const Posture& posture);
    double forward_steps(double speed) const;
    void balance(const Posture& posture);
    void place_leg(Side side, const Foot& foot, JointTargets& out) const;
    void place_arms(double right_swing, double left_swing, JointTargets& out) const;
    Correction landing_shift() const;
    double lean() const { return config_.lean + config_.lean_gain * velocity_.forward; }

    const Config config_;
    kinematics::Leg right_, left_;
    Vec3 hips_;          ///< midway between the hips, torso frame
    double leg_length_;  ///< hip to sole, straight
    double scale_;       ///< leg length over type 0's
    double share_;       ///< of the configured top speeds and accelerations
    Steps steps_;
    Walk velocity_;                                ///< what the present steps are made for
    double pitch_error_ = 0.0, roll_error_ = 0.0;  ///< predicted, against the wanted lean
    double pitch_now_ = 0.0, roll_now_ = 0.0;
    double pitch_rate_ = 0.0, roll_rate_ = 0.0;
    double heading_error_ = 0.0;  ///< turn asked for and not made yet
    bool moving_ = false;
};

}  // namespace k3d::agent::motion::walk
