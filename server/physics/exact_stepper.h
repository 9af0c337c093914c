// SPDX-License-Identifier: BSD-3-Clause
// The reference's step: contact joints for ODE and one dWorldStep, which solves the exact LCP over
// all rows of hinges, motors and contacts (reference 2.1, 5.5).
//
// The motors' bounds cost the LCP a third of its time. Stepping without them first, and again with
// them where a motor went beyond its 10 N m, took 807 us in place of 1197 for five robots on a steady
// walk, and nothing less in a match: each start of a step of our walk asks hips and knees for up to
// 70 N m, so that three cycles in ten were stepped twice. It was left out for that.
#pragma once

#include <ode/ode.h>

#include <span>
#include <vector>

#include "server/physics/collision.h"
#include "server/physics/mechanism.h"

namespace k3d::server::physics {

class ExactStepper {
  public:
    explicit ExactStepper(dWorldID world);
    ~ExactStepper();
    ExactStepper(const ExactStepper&) = delete;
    ExactStepper& operator=(const ExactStepper&) = delete;

    /// Drag, contact joints, one step. Writes the contacts with their forces.
    void step(const std::vector<Mechanism>& mechanisms, const std::vector<Touch>& touches,
              std::vector<Contact>& contacts);

  private:
    dWorldID world_;
    dJointGroupID contact_joints_;
    std::vector<dJointFeedback> feedback_;  ///< one per touch
};

}  // namespace k3d::server::physics
