// SPDX-License-Identifier: BSD-3-Clause
// Joint angles wanted -> joint speeds to send, with the wire's latency compensated exactly.
//
// The percept of cycle n is answered by a command that drives step n + 2, while step n + 1 runs
// with the command before. Motors hold their speed exactly (reference 5.2), so the angle after
// step n + 1 is the measured one plus the command before times the cycle. Radians, rad/s.
#pragma once

#include "agent/motion/joint_targets.h"
#include "agent/motion/motion.h"

namespace k3d::agent::motion {

class JointControl {
  public:
    explicit JointControl(const nao::Model& model) : model_(model) {}

    /// Speeds that bring the joints to `targets`, within each joint's top speed and stops.
    void step(const nao::JointArray& measured, const JointTargets& targets, nao::JointArray& rates);

  private:
    const nao::Model& model_;
    nao::JointArray previous_{};
};

}  // namespace k3d::agent::motion
