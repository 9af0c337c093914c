// SPDX-License-Identifier: BSD-3-Clause
// The reference's step: contact joints for ODE and one dWorldStep, which solves the exact LCP over
// all rows of hinges, motors and contacts (reference 2.1, 5.5).
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
