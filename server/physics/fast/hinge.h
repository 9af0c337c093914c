// SPDX-License-Identifier: BSD-3-Clause
// A powered hinge with stops in the fast stepper: the rate it is held at and the torques that hold
// it. The rules are those of ODE's limit-motor rows (manual 7.5.1, "Stop and motor parameters").
#pragma once

#include <ode/ode.h>

#include <cstdint>

#include "common/math/geometry.h"

namespace k3d::server::physics::fast {

/// Held: the rate is the target, the torque whatever that takes, within [low, high]. Released: the
/// torque is that bound, the rate an unknown.
enum class Grasp : std::uint8_t { Held, AtLow, AtHigh };

struct Hinge {
    // Constants.
    dJointID joint = nullptr;
    Vec3 axis, pivot;                ///< in the child's frame; the pivot from its centre
    Vec3 parent_axis, parent_pivot;  ///< in the parent's
    double low_stop, high_stop;      ///< rad
    double tan_low, tan_high;        ///< of half the stops
    double stop_gain;  ///< 1/s, share of an overshoot that a stop takes back: stop erp / h
    double bounce;
    double max_torque;  ///< N m
    double fudge;       ///< share of the motor's torque left when it drives away from a stop

    // Of this step.
    Vec3 a, r, c;        ///< a_i, r_i and c_i of fast_stepper.h, field axes
    Vec3 r_parent;       ///< r_p
    Vec3 mend_linear;    ///< -(erp / h) e
    Vec3 mend_angular;   ///< (erp / h) a x u
    Vec3 yield_linear;   ///< -cfm f
    Vec3 yield_angular;  ///< -cfm times the torque across a
    double target;       ///< rad/s
    double low, high;    ///< N m
    Grasp grasp;
    double rate;    ///< rad/s, of the solution
    double torque;  ///< N m, on the child about a

    /// Sets target, low and high from motor and stops. `half_sine`, `half_cosine`: of the angle;
    /// `old_rate`: about a, of the velocities before the step.
    void read_motor(double half_sine, double half_cosine, double old_rate);
    /// True if the grasp had to change after `rate` and `torque` were found.
    bool regrasp();
};

/// From ODE's parameters, in the pose in which the angle is 0.
Hinge make_hinge(dJointID joint);

}  // namespace k3d::server::physics::fast
