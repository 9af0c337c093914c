// SPDX-License-Identifier: BSD-3-Clause
#include "contract/body_rig.h"

#include <algorithm>
#include <cmath>

#include "common/clock/clock.h"

namespace k3d::contract {

namespace {

using agent::motion::SoleForce;

/// Body axes of the server -> axes of the agent.
Vec3 to_agent(const Vec3& v) {
    return {v.y(), -v.x(), v.z()};
}

double two_decimals(double value) {
    return std::round(value * 100.0) / 100.0;
}
Vec3 two_decimals(const Vec3& v) {
    return {two_decimals(v.x()), two_decimals(v.y()), two_decimals(v.z())};
}
Vec3 rounded_degrees(const Vec3& v) {
    return two_decimals(Vec3(v * (180.0 / kPi))) * (kPi / 180.0);
}

const Vec3 kGravity(0, 0, -9.81);

}  // namespace

BodyRig::BodyRig(int type, const Pose2& start, server::physics::Stepper stepper)
    : world_(stepper),
      arena_(world_),
      ball_(world_),
      robot_(world_, nao::model(type), 1,
             {start.position.x(), start.position.y(), nao::model(type).standing_height}) {
    ball_.move({14.0, 9.0, 0.042});
    robot_.place(robot_.torso_position(), start.yaw);
    feel();
}

void BodyRig::advance(const nao::JointArray& rates) {
    for (const nao::JointDef& joint : model().joints) {
        robot_.drive(joint.id, pending_[nao::index(joint.id)]);
    }
    pending_ = rates;
    velocity_before_ = velocity_;
    velocity_ = robot_.torso_velocity();
    world_.step();
    ++steps_;
    feel();
}

void BodyRig::feel() {
    sense_.time = steps_ * kCycleSeconds;
    for (const nao::JointDef& joint : model().joints) {
        sense_.joints[nao::index(joint.id)] =
            radians(two_decimals(degrees(robot_.angle(joint.id))));
    }
    const Quat to_torso = robot_.torso_rotation().conjugate();
    sense_.gyro = rounded_degrees(to_agent(to_torso * robot_.torso_angular_velocity()));
    const Vec3 change = (velocity_ - velocity_before_) / kCycleSeconds;
    sense_.acceleration = two_decimals(to_agent(to_torso * (change - kGravity)));
    sense_.right_sole = sole(nao::Part::RFoot);
    sense_.left_sole = sole(nao::Part::LFoot);
}

std::optional<SoleForce> BodyRig::sole(nao::Part foot) const {
    const auto body = static_cast<std::size_t>(*model().body_of(foot));
    Vec3 force = Vec3::Zero();
    Vec3 weighted = Vec3::Zero();
    double total = 0.0;
    bool touched = false;
    for (const server::physics::Contact& contact : world_.contacts()) {
        for (const auto* tag : {contact.a, contact.b}) {
            if (tag->kind != server::physics::Kind::Robot || tag->owner != robot_.owner() ||
                tag->part != foot) {
                continue;
            }
            touched = true;
            const Vec3 on_foot = tag == contact.a ? contact.force_on_a : Vec3(-contact.force_on_a);
            force += on_foot;
            weighted += on_foot.norm() * contact.point;
            total += on_foot.norm();
        }
    }
    if (!touched || total <= 0.0) return std::nullopt;
    const Quat to_foot = robot_.rotation(body).conjugate();
    const Vec3 centre = to_foot * (weighted / total - robot_.position(body));
    return SoleForce{to_agent(two_decimals(centre)), to_agent(two_decimals(Vec3(to_foot * force)))};
}

Pose2 BodyRig::pose() const {
    const Vec3 torso = robot_.torso_position();
    return {{torso.x(), torso.y()}, robot_.heading()};
}

double BodyRig::height() const {
    return robot_.torso_position().z();
}

double BodyRig::tilt() const {
    const Vec3 up = robot_.torso_rotation() * Vec3::UnitZ();
    return std::acos(std::clamp(up.z(), -1.0, 1.0));
}

}  // namespace k3d::contract
