// SPDX-License-Identifier: BSD-3-Clause
// The fast stepper: the velocities that dWorldStep finds, from a system of 6 unknowns a robot, not
// 150.
//
// State, collision, contact points and integration are ODE's; only the solver is ours. What is
// solved:
//
// Units SI; axes of the field frame; every vector of a mechanism is measured from its base, the
// centre of its first link (the torso). Index i runs over links, p is i's parent, and hinge i joins
// the two.
//   h           step, 0.02 s
//   x_i, R_i    centre of mass and rotation of link i (ODE's state)
//   v_i, w_i    its linear and angular velocity; old ones are ODE's state, new ones are sought
//   m_i, I_i    mass; inertia about the centre, turned into the field frame
//   a_i, u_i    axis of hinge i as the child carries it, and as the parent does
//   c_i, d_i    pivot of hinge i and centre of link i, as offsets from the base: c_i = d_p + r_p,
//               d_i = c_i - r_i, with r_p, r_i the pivot as seen from the parent's and the child's
//               centre
//   q_i         rate of hinge i, rad/s
//   V           new twist of the base, (v_0, w_0)
//
// 1. Hinges. ODE asks of each step that two links meet in their pivot and axis, and that a share
//    erp / h of the distance e = (x_i + r_i) - (x_p + r_p) by which integration took them apart be
//    mended:
//        w_i = w_p + a_i q_i + (erp / h) a_i x u_i
//        v_i + w_i x r_i = v_p + w_p x r_p - (erp / h) e
//    (ODE manual 3.7, "Joint error and the error reduction parameter"). The motors are velocity
//    motors, so q_i is known: the set-point, or at a stop what the stop makes of it (hinge.h).
//    Hence all twists follow from V by one walk from the base to the tips:
//    v_i = v_0 + w_0 x d_i + bias.
// 2. Base. The impulses inside the hinges cancel in the sum over all links about the base, which
//    leaves
//        sum_i [ m_i (v_i - v_i*) ; I_i (w_i - w_i*) + d_i x m_i (v_i - v_i*) ] = contact impulses,
//    where v*, w* are the velocities after gravity, drag and the gyroscopic torque alone:
//    6 equations for V, with the composite rigid body inertia M (Featherstone, Rigid Body Dynamics
//    Algorithms, 2008, ch. 6).
// 3. Contacts. A row J V' + b of the relative velocity at a contact point (V' = all unknowns of an
//    island) holds against an impulse L (N s) softly, which is what ODE's constraint force mixing
//    means:
//        J V' + b + (cfm / h) L = target,   i.e.   L = (h / cfm) (target - b - J V')
//    normal    L >= 0; target = erp / h (depth - surface layer), or bounce times the incoming speed
//              if that is more and the speed above the bounce velocity; cfm = soft_cfm
//    tangents  L free (every surface of reference 5.5 has mu = infinity, so ODE's friction has no
//              bound); target 0; cfm = slip
//    (ODE manual 3.8, 3.9, 7.3.7). Since every row is soft, the impulses drop out: V' solves
//        (M + sum J^T (h / cfm) J) V' = momentum + sum J^T (h / cfm) (target - b)
//    over the tangents and those normals that push. Which ones push is found by pivoting
//    (island.h); the answer is the one solution of ODE's LCP, not an approximation by sweeps.
// 4. Torques. A second walk from the tips to the base sums what each hinge must transmit
//    (Featherstone ch. 5). Where that exceeds the motor's 10 N m, or what a stop can give, the
//    hinge is released: its torque is then the bound, its rate q_i an unknown of V', and the system
//    is solved again.
// 5. Yielding. ODE's hinge rows are soft too: a hinge gives way by cfm (1e-5 m/s per N, rad/s per
//    N m) to the force it transmits, along all rows but the motor's, which is a thousand times
//    stiffer. The forces are known once the rigid system is solved; so it is solved again with the
//    hinges' rates of 1. changed by that much, twice. The share of the error that remains each time
//    is about the hinges' softness over that of the ground and of the robot's own inertia, h / m:
//    a tenth or less on two feet, more where several limbs are braced against the ground.
//
// The velocities after a step then agree with dWorldStep's to 1e-5 m/s (median, walking) and 5e-3 m/s (worst,
// lying braced); tests/contract/one_step_test.cpp watches that. One thing differs on purpose: nothing is put to
// sleep, where ODE stops a body that moved less than 1 cm/s and 0.01 rad/s for ten steps.
#pragma once

#include <ode/ode.h>

#include <memory>
#include <vector>

#include "server/physics/collision.h"
#include "server/physics/fast/island.h"
#include "server/physics/fast/linkage.h"
#include "server/physics/mechanism.h"

namespace k3d::server::physics::fast {

class FastStepper {
  public:
    explicit FastStepper(dWorldID world);

    void add(const Mechanism& mechanism);
    void remove(const dxBody* first);  ///< the mechanism with this first body

    /// One step of all mechanisms. Writes the contacts with their forces. Throws Diverged.
    void step(const std::vector<Touch>& touches, std::vector<Contact>& contacts);

  private:
    void label_islands();
    void solve_island(std::size_t label);

    Settings settings_;
    std::vector<std::unique_ptr<Linkage>> linkages_;
    std::vector<Grip> grips_;        ///< one per touch
    std::vector<Linkage*> members_;  ///< of the island at hand
    std::vector<Grip*> holds_;
    IslandSolver solver_;
};

}  // namespace k3d::server::physics::fast
