// SPDX-License-Identifier: BSD-3-Clause
#include "server/body/ball.h"

#include <ode/ode.h>

#include "common/field/field.h"
#include "server/body/pose.h"

namespace k3d::server::body {

namespace {
constexpr double kLinearDrag = 0.01;     // N s/m
constexpr double kAngularDrag = 0.00005;  // N m s: the only rolling resistance
}  // namespace

Ball::Ball(physics::World& world)
    : world_(world), group_(world.add_group()), body_(dBodyCreate(world.ode())) {
    dMass mass;
    dMassSetSphereTotal(&mass, field::kBallMass, field::kBallRadius);
    dBodySetMass(body_, &mass);
    const dGeomID geom = dCreateSphere(nullptr, field::kBallRadius);
    dGeomSetBody(geom, body_);
    dGeomSetData(geom, &tag_);
    world_.add_geom(group_, geom);
    dBodySetPosition(body_, 0, 0, field::kBallRadius);
    world_.add_mechanism({{body_}, {}, kLinearDrag, kAngularDrag});
}

Ball::~Ball() {
    world_.remove_mechanism(body_);
    world_.remove_group(group_);
    dBodyDestroy(body_);
}

Vec3 Ball::position() const { return position_of(body_); }
Quat Ball::rotation() const { return rotation_of(body_); }
Vec3 Ball::velocity() const { return velocity_of(body_); }

void Ball::move(const Vec3& position) {
    dBodySetPosition(body_, position.x(), position.y(), position.z());
    dBodyEnable(body_);
}

void Ball::set_velocity(const Vec3& velocity) {
    dBodySetLinearVel(body_, velocity.x(), velocity.y(), velocity.z());
    dBodySetAngularVel(body_, 0, 0, 0);
    dBodyEnable(body_);
}

}  // namespace k3d::server::body
