// SPDX-License-Identifier: BSD-3-Clause
// Gets a fallen robot back on its feet: straightens the limbs, waits until the body lies still,
// finds the side it lies on by the vertical in torso axes, plays that side's keyframes and tries
// again, slower, until it stands.
//
// Keyframes are open-loop and found by search in the exact physics (see getup.toml); the robot is
// first brought to one pose, so that they always start from nearly the same state. Radians, s.
#pragma once

#include "agent/motion/getup/config.h"
#include "agent/motion/joint_targets.h"
#include "agent/motion/keyframe.h"
#include "agent/motion/motion.h"
#include "agent/motion/posture.h"

namespace k3d::agent::getup {

/// What the body lies on.
enum class Lying { Upright, OnBack, OnFront, OnRight, OnLeft };

/// From the vertical in torso axes (x forward, y left, z up).
Lying lying_on(const Vec3& up);

class GetUp {
  public:
    /// For a robot of `type`, 0 to 4.
    GetUp(const Config& config, int type);

    /// Begins from any pose; `stand` is the pose to end in.
    void start(const nao::JointArray& stand);
    /// Writes all joints but the head's. False once the robot stands.
    bool step(const motion::BodySense& sense, const motion::Posture& posture,
              motion::JointTargets& out);

  private:
    enum class Phase { Tuck, Rest, Roll, Sequence, Settle };

    void begin(Phase phase);
    void act_on(Lying lying);
    void add_sequence(const Sequence& sequence);
    bool advance_frames();
    bool lies_still(const motion::Posture& posture);

    Config config_;
    Sequences sequences_;  ///< of this type
    Phase phase_ = Phase::Tuck;
    /// Still to be played in this phase, the running one first.
    std::vector<motion::Keyframe> frames_;
    int cycle_ = 0;                 ///< of the running keyframe, or of the phase if it has none
    int calm_cycles_ = 0;           ///< in a row
    int tries_ = 0;                 ///< keyframe sequences begun since start()
    bool fresh_ = true;        ///< pose_ is not known yet
    nao::JointArray from_{};   ///< where the running keyframe began
    nao::JointArray pose_{};   ///< wanted now
    nao::JointArray stand_{};
};

}  // namespace k3d::agent::getup
