// SPDX-License-Identifier: BSD-3-Clause
// What every motion engine (walk, kick, get up, head) hands to joint_control: the angles the joints
// shall have. An engine is a small class built from (const nao::Model&, const its Config&) with
//     void start(...);                                                      // a new motion
//     bool step(const BodySense&, const Posture&, JointTargets& out);      // true while running
// step() is called once a cycle, writes the joints it owns and leaves the others. Engines know
// nothing of the wire's latency: joint_control predicts the angles at the time its rates act, so a
// target set now is reached at the end of the cycle after the running one, if the joint's top
// speed allows.
#pragma once

#include "common/nao/model.h"

namespace k3d::agent::motion {

struct JointTargets {
    nao::JointArray angle{};  ///< rad, table's sign convention, by nao::index(JointId)

    double& operator[](nao::JointId id) { return angle[nao::index(id)]; }
    double operator[](nao::JointId id) const { return angle[nao::index(id)]; }
};

}  // namespace k3d::agent::motion
