// SPDX-License-Identifier: BSD-3-Clause
// What moves: one body, or bodies linked to a tree by powered hinges.
//
// ODE holds masses, poses, velocities, hinge axes, stops and motor rates; both steppers read them
// there.
#pragma once

#include <vector>

struct dxBody;
struct dxJoint;

namespace k3d::server::physics {

/// Hinge k links bodies[k + 1] (ODE's body 1) to a body before it (ODE's body 2). The pose in which
/// a mechanism is added to the world is the one in which all its hinges stand at angle 0.
struct Mechanism {
    std::vector<dxBody*> bodies;
    std::vector<dxJoint*> hinges;
    /// Every body is damped by force -linear_drag v and torque -angular_drag w (reference 5.5).
    double linear_drag = 0.0;   ///< N s/m
    double angular_drag = 0.0;  ///< N m s
};

}  // namespace k3d::server::physics
