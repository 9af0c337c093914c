// SPDX-License-Identifier: BSD-3-Clause
// A contact point in the fast stepper: three soft rows between two links, or a link and what stands
// still. Equations: fast_stepper.h, 3.
#pragma once

#include <array>
#include <cstddef>

#include "server/physics/collision.h"
#include "server/physics/fast/linkage.h"

namespace k3d::server::physics::fast {

/// One side of a contact.
struct Side {
    Linkage* linkage = nullptr;  ///< null: stands still
    std::size_t link = 0;
    Vec3 offset = Vec3::Zero();  ///< of the point from the linkage's base
};

struct Grip {
    Side a, b;  ///< velocities and impulses count as a's against b
    Vec3 point;
    std::array<Vec3, 3> directions;   ///< normal towards a, two tangents
    std::array<double, 3> stiffness;  ///< h / cfm, kg
    double target;                    ///< m/s, along the normal
    bool pushes;                      ///< the normal row is in force
    Vec3 impulse;                     ///< N s on a, of the solution

    /// Velocity of a against b at the point, by one of Linkage's velocities.
    Vec3 relative(Vec3 (Linkage::*velocity)(std::size_t, const Vec3&) const) const;
};

/// Reads a touch; `pushes` is a first guess from the velocities before the step.
Grip make_grip(const Touch& touch, const Settings& settings);

}  // namespace k3d::server::physics::fast
