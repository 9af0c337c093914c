// SPDX-License-Identifier: BSD-3-Clause
#include "server/body/robot.h"

#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "server/body/pose.h"

namespace k3d::server::body {

namespace {

constexpr double kDrag = 0.01;  // N s/m and N m s, every body of a Nao (reference 5.5)

dMass mass_of(const nao::BodyDef& def) {
    dMass mass;
    switch (def.shape) {
        case nao::Shape::Box:
            dMassSetBoxTotal(&mass, def.mass, def.size.x(), def.size.y(), def.size.z());
            break;
        case nao::Shape::Sphere:
            dMassSetSphereTotal(&mass, def.mass, def.size.x());
            break;
        case nao::Shape::Capsule:
            dMassSetCapsuleTotal(&mass, def.mass, 3, def.size.x(), def.size.y());
            break;
    }
    return mass;
}

dGeomID collider_of(const nao::BodyDef& def) {
    switch (def.shape) {
        case nao::Shape::Sphere:
            return dCreateSphere(nullptr, def.size.x());
        case nao::Shape::Capsule:
            return dCreateCapsule(nullptr, def.size.x(), def.size.y());
        case nao::Shape::Box:
            break;
    }
    return dCreateBox(nullptr, def.size.x(), def.size.y(), def.size.z());
}

}  // namespace

Robot::Robot(physics::World& world, const nao::Model& model, int owner, const Vec3& torso)
    : world_(world), model_(model), owner_(owner), group_(world.add_group()) {
    tags_.resize(model.bodies.size());  // geoms point into it: never resized again
    std::vector<Vec3> positions;
    for (const nao::BodyDef& def : model.bodies) {
        positions.push_back(def.parent < 0
                                ? torso
                                : positions[static_cast<std::size_t>(def.parent)] + def.offset);
        add_body(def, positions.back());
    }
    physics::Mechanism mechanism{bodies_, {}, kDrag, kDrag};
    for (const nao::JointDef& def : model.joints) {
        add_joint(def);
        mechanism.hinges.push_back(joints_[nao::index(def.id)]);
    }
    world_.add_mechanism(std::move(mechanism));
}

void Robot::add_body(const nao::BodyDef& def, const Vec3& position) {
    const dBodyID body = dBodyCreate(world_.ode());
    const dMass mass = mass_of(def);
    dBodySetMass(body, &mass);
    dBodySetPosition(body, position.x(), position.y(), position.z());
    if (def.collides) {
        const dGeomID geom = collider_of(def);
        dGeomSetBody(geom, body);
        physics::Tag& tag = tags_[bodies_.size()];
        tag = {&physics::kRobotSurface, physics::Kind::Robot, owner_, def.part};
        dGeomSetData(geom, &tag);
        world_.add_geom(group_, geom);
    }
    bodies_.push_back(body);
}

void Robot::add_joint(const nao::JointDef& def) {
    const auto child = static_cast<std::size_t>(def.child);
    const auto parent = static_cast<std::size_t>(model_.bodies[child].parent);
    const dJointID joint = dJointCreateHinge(world_.ode(), nullptr);
    dJointAttach(joint, bodies_[child], bodies_[parent]);
    // At zero pose all bodies are parallel to the world, so the child's axis is the world's.
    const Vec3 anchor = position_of(bodies_[child]) + def.anchor;
    dJointSetHingeAnchor(joint, anchor.x(), anchor.y(), anchor.z());
    dJointSetHingeAxis(joint, def.axis.x(), def.axis.y(), def.axis.z());
    dJointSetHingeParam(joint, dParamLoStop, def.min);
    dJointSetHingeParam(joint, dParamHiStop, def.max);
    dJointSetHingeParam(joint, dParamFMax, nao::kMaxTorque);
    dJointSetHingeParam(joint, dParamVel, 0.0);
    dJointSetHingeParam(joint, dParamCFM, 1e-8);
    dJointSetHingeParam(joint, dParamStopCFM, 1e-8);
    dJointSetHingeParam(joint, dParamStopERP, 0.8);
    dJointSetHingeParam(joint, dParamFudgeFactor, 1e-5);
    dJointSetHingeParam(joint, dParamBounce, 1.0);
    joints_[nao::index(def.id)] = joint;
    defs_[nao::index(def.id)] = &def;
}

Robot::~Robot() {
    world_.remove_mechanism(bodies_.front());
    world_.remove_group(group_);
    for (const dJointID joint : joints_) {
        if (joint != nullptr) dJointDestroy(joint);
    }
    for (const dBodyID body : bodies_) dBodyDestroy(body);
}

void Robot::drive(nao::JointId id, double rate) {
    const dJointID joint = joints_[nao::index(id)];
    if (joint == nullptr || !std::isfinite(rate)) return;
    const nao::JointDef& def = *defs_[nao::index(id)];
    const double clamped = std::clamp(rate, -def.max_rate, def.max_rate);
    const double now = measured(nao::index(id));
    if (now > def.min && now < def.max) dJointSetHingeParam(joint, dParamVel, clamped);
    if (clamped != 0.0) dBodyEnable(bodies_[static_cast<std::size_t>(def.child)]);
}

double Robot::angle(nao::JointId id) const {
    const dJointID joint = joints_[nao::index(id)];
    return joint == nullptr ? 0.0 : measured(nao::index(id));
}

double Robot::measured(std::size_t joint) const {
    if (angles_of_ != world_.revision()) angle_known_.reset();
    angles_of_ = world_.revision();
    if (!angle_known_[joint]) angles_[joint] = dJointGetHingeAngle(joints_[joint]);
    angle_known_.set(joint);
    return angles_[joint];
}

Vec3 Robot::position(std::size_t body) const { return position_of(bodies_[body]); }
Quat Robot::rotation(std::size_t body) const { return rotation_of(bodies_[body]); }
Vec3 Robot::torso_velocity() const { return velocity_of(bodies_[0]); }
Vec3 Robot::torso_angular_velocity() const { return angular_velocity_of(bodies_[0]); }

double Robot::heading() const {
    const Vec3 forward = torso_rotation() * Vec3::UnitY();
    return std::atan2(forward.y(), forward.x());
}

void Robot::move(const Vec3& torso) { transform(torso, Quat::Identity()); }

void Robot::place(const Vec3& torso, double heading) {
    // The body's forward axis is +y, so a heading of 90 degrees is no rotation.
    const Quat upright(Eigen::AngleAxisd(heading - kPi / 2.0, Vec3::UnitZ()));
    transform(torso, upright * torso_rotation().conjugate());
}

void Robot::transform(const Vec3& torso, const Quat& turn) {
    angle_known_.reset();  // rigid, but not to the last bit
    const Vec3 old_torso = torso_position();
    for (const dBodyID body : bodies_) {
        const Vec3 p = torso + turn * (position_of(body) - old_torso);
        const Quat q = (turn * rotation_of(body)).normalized();
        const dQuaternion quaternion{q.w(), q.x(), q.y(), q.z()};
        dBodySetPosition(body, p.x(), p.y(), p.z());
        dBodySetQuaternion(body, quaternion);
        dBodySetLinearVel(body, 0, 0, 0);
        dBodySetAngularVel(body, 0, 0, 0);
        dBodySetForce(body, 0, 0, 0);
        dBodySetTorque(body, 0, 0, 0);
        dBodyEnable(body);
    }
}

}  // namespace k3d::server::body
