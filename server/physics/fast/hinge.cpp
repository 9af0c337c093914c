// SPDX-License-Identifier: BSD-3-Clause
#include "server/physics/fast/hinge.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/clock/clock.h"

namespace k3d::server::physics::fast {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Slack against rounding: a pair of states that differ by less must not be flipped to and fro.
constexpr double kTorqueSlack = 1e-9;  // N m
constexpr double kRateSlack = 1e-10;   // rad/s

Vec3 in_frame_of(dBodyID body, const Vec3& point) {
    dVector3 local;
    dBodyGetPosRelPoint(body, point.x(), point.y(), point.z(), local);
    return {local[0], local[1], local[2]};
}
Vec3 turned_into(dBodyID body, const Vec3& direction) {
    dVector3 local;
    dBodyVectorFromWorld(body, direction.x(), direction.y(), direction.z(), local);
    return {local[0], local[1], local[2]};
}

}  // namespace

Hinge make_hinge(dJointID joint) {
    const dBodyID child = dJointGetBody(joint, 0);
    const dBodyID parent = dJointGetBody(joint, 1);
    dVector3 v;
    dJointGetHingeAnchor(joint, v);
    const Vec3 pivot(v[0], v[1], v[2]);
    dJointGetHingeAxis(joint, v);
    const Vec3 axis(v[0], v[1], v[2]);
    Hinge h{};
    h.joint = joint;
    h.axis = turned_into(child, axis);
    h.pivot = in_frame_of(child, pivot);
    h.parent_axis = turned_into(parent, axis);
    h.parent_pivot = in_frame_of(parent, pivot);
    h.low_stop = dJointGetHingeParam(joint, dParamLoStop);
    h.high_stop = dJointGetHingeParam(joint, dParamHiStop);
    h.tan_low = std::tan(h.low_stop / 2.0);
    h.tan_high = std::tan(h.high_stop / 2.0);
    h.stop_gain = dJointGetHingeParam(joint, dParamStopERP) / kCycleSeconds;
    h.bounce = dJointGetHingeParam(joint, dParamBounce);
    h.max_torque = dJointGetHingeParam(joint, dParamFMax);
    h.fudge = dJointGetHingeParam(joint, dParamFudgeFactor);
    return h;
}

void Hinge::read_motor(double half_sine, double half_cosine, double old_rate) {
    grasp = Grasp::Held;
    const double set_point = dJointGetHingeParam(joint, dParamVel);
    const bool at_low = half_sine <= tan_low * half_cosine;  // tan is monotonic over (-pi, pi) / 2
    const bool at_high = half_sine >= tan_high * half_cosine;
    if (!at_low && !at_high) {
        target = set_point;
        low = -max_torque;
        high = max_torque;
        return;
    }
    const double angle = 2.0 * std::atan2(half_sine, half_cosine);
    if (at_low) {
        // The stop only pushes up, on top of the motor's constant torque.
        target =
            std::max(-stop_gain * (angle - low_stop), old_rate < 0.0 ? -bounce * old_rate : 0.0);
        low = set_point > 0.0 ? fudge * max_torque : -max_torque;
        high = kInfinity;
    } else {
        target =
            std::min(-stop_gain * (angle - high_stop), old_rate > 0.0 ? -bounce * old_rate : 0.0);
        low = -kInfinity;
        high = set_point < 0.0 ? -fudge * max_torque : max_torque;
    }
}

bool Hinge::regrasp() {
    const Grasp before = grasp;
    switch (grasp) {
        case Grasp::Held:
            if (torque < low - kTorqueSlack) grasp = Grasp::AtLow;
            if (torque > high + kTorqueSlack) grasp = Grasp::AtHigh;
            break;
        case Grasp::AtLow:  // the child outruns the target, or there is no need for the bound
            if (rate < target - kRateSlack) grasp = Grasp::Held;
            break;
        case Grasp::AtHigh:
            if (rate > target + kRateSlack) grasp = Grasp::Held;
            break;
    }
    return grasp != before;
}

}  // namespace k3d::server::physics::fast
