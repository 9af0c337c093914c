// SPDX-License-Identifier: BSD-3-Clause
#include "server/physics/fast/linkage.h"

#include <cmath>

#include "common/clock/clock.h"
#include "common/log/log.h"

namespace k3d::server::physics::fast {

namespace {

constexpr double h = kCycleSeconds;

Vec3 vector(const dReal* v) {
    return {v[0], v[1], v[2]};
}

Mat3 matrix(const dReal* rows_of_4) {
    Mat3 m;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) m(r, c) = rows_of_4[4 * r + c];
    }
    return m;
}

/// Angular momentum, own axes, after the gyroscopic torque of a step, as ODE has it: implicit,
/// after Lacoursiere, "Stabilizing gyroscopic forces in rigid multibody simulations", 2006.
Vec3 turned_momentum(const Vec3& inertia, const Vec3& angular) {
    const Vec3 l = inertia.cwiseProduct(angular);
    Mat3 implicit;
    implicit << inertia.x(), h * l.z(), -h * l.y(),  //
        -h * l.z(), inertia.y(), h * l.x(),          //
        h * l.y(), -h * l.x(), inertia.z();
    return inertia.cwiseProduct(Vec3(implicit.inverse() * l));
}

/// m (|d|^2 1 - d d^T)
Mat3 inertia_of_point(double mass, const Vec3& d) {
    return mass * (d.squaredNorm() * Mat3::Identity() - d * d.transpose());
}

}  // namespace

Linkage::Linkage(const Mechanism& mechanism, const Settings& settings)
    : settings_(settings),
      linear_drag_(mechanism.linear_drag),
      angular_drag_(mechanism.angular_drag) {
    const std::size_t count = mechanism.bodies.size();
    K3D_ASSERT(count <= 64);  // Link::path has a bit per link
    hinges_.resize(count);
    for (const dBodyID body : mechanism.bodies) add_link(body);
    for (const dJointID joint : mechanism.hinges) {
        for (std::size_t i = 0; i < count; ++i) {
            if (links_[i].body == dJointGetBody(joint, 0)) add_hinge(joint, i);
        }
    }
    states_.resize(count);
    below_.resize(count);
    missing_.resize(count);
    carried_.resize(count);
    for (std::size_t i = 0; i < count; ++i) places_.push_back({this, i});
    for (std::size_t i = 0; i < count; ++i) dBodySetData(links_[i].body, &places_[i]);
}

void Linkage::add_link(dBodyID body) {
    dMass mass;
    dBodyGetMass(body, &mass);
    Link link{};
    link.body = body;
    link.position = dBodyGetPosition(body);
    link.rotation = dBodyGetRotation(body);
    link.quaternion = dBodyGetQuaternion(body);
    link.linear = dBodyGetLinearVel(body);
    link.angular = dBodyGetAngularVel(body);
    link.mass = mass.mass;
    link.inertia = {mass.I[0], mass.I[5], mass.I[10]};
    link.round = mass.I[0] == mass.I[5] && mass.I[5] == mass.I[10];
    link.path = std::uint64_t{1} << links_.size();
    links_.push_back(link);
}

void Linkage::add_hinge(dJointID joint, std::size_t link) {
    hinges_[link] = make_hinge(joint);
    for (std::size_t p = 0; p < link; ++p) {
        if (links_[p].body != dJointGetBody(joint, 1)) continue;
        links_[link].parent = p;
        links_[link].path |= links_[p].path;
    }
}

void Linkage::read() {
    released_.clear();
    for (std::size_t i = 0; i < links_.size(); ++i) {
        states_[i].rotation = matrix(links_[i].rotation);
        if (i > 0) read_hinge(i);
        read_link(i);
    }
    for (std::size_t i = links_.size() - 1; i > 0; --i) {
        Composite& parent = below_[links_[i].parent];
        parent.mass += below_[i].mass;
        parent.moment += below_[i].moment;
        parent.inertia += below_[i].inertia;
    }
    set_bias();
}

void Linkage::read_hinge(std::size_t i) {
    const Link& link = links_[i];
    const Link& parent = links_[link.parent];
    const LinkState& parent_state = states_[link.parent];
    Hinge& hinge = hinges_[i];
    hinge.a = states_[i].rotation * hinge.axis;
    hinge.r = states_[i].rotation * hinge.pivot;
    hinge.r_parent = parent_state.rotation * hinge.parent_pivot;
    hinge.c = parent_state.offset + hinge.r_parent;
    states_[i].offset = hinge.c - hinge.r;
    const double mend = settings_.erp / h;
    const Vec3 gap = (vector(link.position) + hinge.r) - (vector(parent.position) + hinge.r_parent);
    hinge.mend_linear = -mend * gap;
    hinge.mend_angular = mend * hinge.a.cross(Vec3(parent_state.rotation * hinge.parent_axis));

    hinge.yield_linear = hinge.yield_angular = Vec3::Zero();

    const dReal* q = link.quaternion;
    const dReal* p = parent.quaternion;
    // conj(p) q. Of its vector part ODE takes the whole length, also what is not along the axis.
    const Vec3 sine =
        p[0] * vector(q + 1) - q[0] * vector(p + 1) - vector(p + 1).cross(vector(q + 1));
    const double cosine = p[0] * q[0] + vector(p + 1).dot(vector(q + 1));
    const bool backwards = (sine.dot(hinge.parent_axis) < 0.0) != (cosine < 0.0);
    const double old_rate = hinge.a.dot(vector(link.angular) - vector(parent.angular));
    hinge.read_motor(backwards ? -sine.norm() : sine.norm(), std::abs(cosine), old_rate);
}

void Linkage::read_link(std::size_t i) {
    const Link& link = links_[i];
    LinkState& state = states_[i];
    if (i == 0) state.offset = Vec3::Zero();
    const Vec3 v = vector(link.linear);
    const Vec3 w = vector(link.angular);
    state.free_momentum = link.mass * v + h * (link.mass * settings_.gravity - linear_drag_ * v);
    if (link.round) {
        state.inertia = link.inertia.x() * Mat3::Identity();
        state.free_spin = link.inertia.x() * w;
    } else {
        const Mat3& turn = state.rotation;
        state.inertia = turn * link.inertia.asDiagonal() * turn.transpose();
        state.free_spin = turn * turned_momentum(link.inertia, turn.transpose() * w);
    }
    state.free_spin -= h * angular_drag_ * w;
    below_[i] = {link.mass, link.mass * state.offset,
                 state.inertia + inertia_of_point(link.mass, state.offset)};
}

void Linkage::set_bias() {
    for (std::size_t i = 1; i < links_.size(); ++i) {
        hinges_[i].rate = hinges_[i].grasp == Grasp::Held ? hinges_[i].target : 0.0;
    }
    propagate({}, &LinkState::bias);
    for (std::size_t i = 0; i < links_.size(); ++i) {
        const LinkState& state = states_[i];
        const Vec3 linear = state.free_momentum - links_[i].mass * state.bias.linear;
        const Vec3 spin = state.free_spin - state.inertia * state.bias.angular;
        missing_[i] = {linear, spin + state.offset.cross(linear)};
    }
    sum_to_base(missing_);
}

void Linkage::propagate(const Twist& base, Twist LinkState::*out) {
    states_[0].*out = base;
    for (std::size_t i = 1; i < links_.size(); ++i) {
        const Hinge& hinge = hinges_[i];
        const Twist& parent = states_[links_[i].parent].*out;
        Twist& own = states_[i].*out;
        own.angular =
            parent.angular + hinge.rate * hinge.a + hinge.mend_angular + hinge.yield_angular;
        own.linear = parent.linear + parent.angular.cross(hinge.r_parent) -
                     own.angular.cross(hinge.r) + hinge.mend_linear + hinge.yield_linear;
    }
}

void Linkage::sum_to_base(std::vector<Wrench>& wrenches) const {
    for (std::size_t i = links_.size() - 1; i > 0; --i) wrenches[links_[i].parent] += wrenches[i];
}

void Linkage::add_inertia(double* matrix, std::size_t stride) const {
    const std::size_t at = column;
    const auto entry = [&](std::size_t r, std::size_t c) -> double& {
        return matrix[(at + r) * stride + at + c];
    };
    const auto add_column = [&](std::size_t row, const Wrench& momentum) {
        for (std::size_t k = 0; k < 3; ++k) {
            entry(row, k) += momentum.linear[static_cast<Eigen::Index>(k)];
            entry(row, 3 + k) += momentum.angular[static_cast<Eigen::Index>(k)];
        }
    };
    const Composite& all = below_[0];
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        entry(k, k) += all.mass;
        const Vec3 crossed = Vec3::Unit(axis).cross(all.moment);
        for (std::size_t j = 0; j < 3; ++j) {
            const auto other = static_cast<Eigen::Index>(j);
            entry(3 + k, j) += crossed[other];
            if (j <= k) entry(3 + k, 3 + j) += all.inertia(axis, other);
        }
    }
    for (std::size_t n = 0; n < released_.size(); ++n) {
        const std::size_t j = released_[n];
        const Hinge& hinge = hinges_[j];
        const Composite& part = below_[j];
        // Momentum of the subtree when the hinge turns with 1 rad/s.
        const Vec3 shift = hinge.a.cross(hinge.c);
        const Wrench unit{hinge.a.cross(part.moment) - part.mass * shift,
                          part.inertia * hinge.a - part.moment.cross(shift)};
        add_column(6 + n, unit);
        for (std::size_t m = 0; m <= n; ++m) {
            const Hinge& other = hinges_[released_[m]];
            if ((links_[j].path >> released_[m] & 1) == 0) continue;
            entry(6 + n, 6 + m) += other.a.dot(unit.angular - other.c.cross(unit.linear));
        }
    }
}

void Linkage::add_momentum(double* right) const {
    double* own = right + column;
    for (int k = 0; k < 3; ++k) {
        own[k] += missing_[0].linear[k];
        own[3 + k] += missing_[0].angular[k];
    }
    for (std::size_t n = 0; n < released_.size(); ++n) {
        const std::size_t j = released_[n];
        const Hinge& hinge = hinges_[j];
        const double bound = hinge.grasp == Grasp::AtLow ? hinge.low : hinge.high;
        own[6 + n] +=
            hinge.a.dot(missing_[j].angular - hinge.c.cross(missing_[j].linear)) + h * bound;
    }
}

void Linkage::jacobian(std::size_t link, const Vec3& offset, const Vec3& direction,
                       double* row) const {
    const Vec3 turning = offset.cross(direction);
    for (int k = 0; k < 3; ++k) {
        row[k] = direction[k];
        row[3 + k] = turning[k];
    }
    for (std::size_t n = 0; n < released_.size(); ++n) {
        const Hinge& hinge = hinges_[released_[n]];
        const bool moves = (links_[link].path >> released_[n] & 1) != 0;
        row[6 + n] = moves ? hinge.a.dot((offset - hinge.c).cross(direction)) : 0.0;
    }
}

Vec3 Linkage::offset_of(std::size_t link, const Vec3& point) const {
    return states_[link].offset + (point - vector(links_[link].position));
}

Vec3 Linkage::old_velocity(std::size_t link, const Vec3& point) const {
    const Link& l = links_[link];
    return vector(l.linear) + vector(l.angular).cross(point - vector(l.position));
}

Vec3 Linkage::bias_velocity(std::size_t link, const Vec3& point) const {
    const Twist& bias = states_[link].bias;
    return bias.linear + bias.angular.cross(point - vector(links_[link].position));
}

void Linkage::take_solution(const double* unknowns) {
    for (std::size_t n = 0; n < released_.size(); ++n) {
        hinges_[released_[n]].rate = unknowns[6 + n];
    }
    propagate({{unknowns[0], unknowns[1], unknowns[2]}, {unknowns[3], unknowns[4], unknowns[5]}},
              &LinkState::twist);
    for (LinkState& state : states_) state.push = {};
}

void Linkage::push(std::size_t link, const Vec3& offset, const Vec3& impulse) {
    states_[link].push += {impulse, offset.cross(impulse)};
}

bool Linkage::release_hinges(bool one_only) {
    carried_[0] = {};
    for (std::size_t i = 1; i < links_.size(); ++i) {
        const LinkState& state = states_[i];
        const Vec3 linear = links_[i].mass * state.twist.linear - state.free_momentum;
        const Vec3 spin = state.inertia * state.twist.angular - state.free_spin;
        carried_[i] = {linear - state.push.linear,
                       spin + state.offset.cross(linear) - state.push.angular};
    }
    sum_to_base(carried_);
    bool moved = false;
    for (std::size_t i = 1; i < links_.size() && !(moved && one_only); ++i) {
        Hinge& hinge = hinges_[i];
        hinge.torque = hinge.a.dot(carried_[i].angular - hinge.c.cross(carried_[i].linear)) / h;
        moved = hinge.regrasp() || moved;
    }
    if (!moved) return false;
    released_.clear();
    for (std::size_t i = 1; i < links_.size(); ++i) {
        if (hinges_[i].grasp != Grasp::Held) released_.push_back(i);
    }
    set_bias();
    return true;
}

void Linkage::yield_to_forces() {
    for (std::size_t i = 1; i < links_.size(); ++i) {
        Hinge& hinge = hinges_[i];
        const Wrench& carried = carried_[i];
        const Vec3 moment = carried.angular - hinge.c.cross(carried.linear);
        hinge.yield_linear = -settings_.cfm / h * carried.linear;
        hinge.yield_angular = -settings_.cfm / h * (moment - hinge.a.dot(moment) * hinge.a);
    }
    set_bias();
}

void Linkage::write() const {
    for (std::size_t i = 0; i < links_.size(); ++i) {
        const Link& link = links_[i];
        const Vec3& v = states_[i].twist.linear;
        const Vec3& w = states_[i].twist.angular;
        const Vec3 x = vector(link.position) + h * v;
        const double s = link.quaternion[0];
        const Vec3 u = vector(link.quaternion + 1);
        const double ds = -0.5 * w.dot(u);
        const Vec3 du = 0.5 * (s * w + w.cross(u));
        const dQuaternion turned{s + h * ds, u.x() + h * du.x(), u.y() + h * du.y(),
                                 u.z() + h * du.z()};
        dBodySetPosition(link.body, x.x(), x.y(), x.z());
        dBodySetQuaternion(link.body, turned);
        dBodySetLinearVel(link.body, v.x(), v.y(), v.z());
        dBodySetAngularVel(link.body, w.x(), w.y(), w.z());
    }
}

}  // namespace k3d::server::physics::fast
