// SPDX-License-Identifier: BSD-3-Clause
#include "server/physics/exact_stepper.h"

#include "common/clock/clock.h"

namespace k3d::server::physics {

namespace {

void apply_drag(const Mechanism& mechanism) {
    const double linear = mechanism.linear_drag;
    const double angular = mechanism.angular_drag;
    for (const dBodyID body : mechanism.bodies) {
        const dReal* v = dBodyGetLinearVel(body);
        const dReal* w = dBodyGetAngularVel(body);
        dBodyAddForce(body, -linear * v[0], -linear * v[1], -linear * v[2]);
        dBodyAddTorque(body, -angular * w[0], -angular * w[1], -angular * w[2]);
    }
}

}  // namespace

ExactStepper::ExactStepper(dWorldID world) : world_(world), contact_joints_(dJointGroupCreate(0)) {}

ExactStepper::~ExactStepper() {
    dJointGroupDestroy(contact_joints_);
}

void ExactStepper::step(const std::vector<Mechanism>& mechanisms, const std::vector<Touch>& touches,
                        std::vector<Contact>& contacts) {
    for (const Mechanism& mechanism : mechanisms) apply_drag(mechanism);
    feedback_.assign(touches.size(), {});  // before any joint points into it
    for (std::size_t i = 0; i < touches.size(); ++i) {
        const dJointID joint = dJointCreateContact(world_, contact_joints_, &touches[i].contact);
        dJointAttach(joint, touches[i].body_a, touches[i].body_b);
        dJointSetFeedback(joint, &feedback_[i]);
    }
    dWorldStep(world_, kCycleSeconds);
    contacts.clear();
    for (std::size_t i = 0; i < touches.size(); ++i) {
        const Touch& touch = touches[i];
        const dReal* p = touch.contact.geom.pos;
        const dReal* f = feedback_[i].f1;
        contacts.push_back({touch.a, touch.b, {p[0], p[1], p[2]}, {f[0], f[1], f[2]}});
    }
    dJointGroupEmpty(contact_joints_);
}

}  // namespace k3d::server::physics
