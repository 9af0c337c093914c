// SPDX-License-Identifier: BSD-3-Clause
// The ODE world: one dWorldStep of 20 ms over manually ordered collision pairs.
#include "server/physics/world.h"

#include <ode/ode.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <utility>
#include <vector>

#include "common/clock/clock.h"

namespace k3d::server::physics {

namespace {

constexpr int kMaxContactsPerPair = 4;
constexpr double kGravity = 9.81;
/// What no body of a match reaches: beyond it, in m and in m/s or rad/s, the physics has broken.
constexpr double kFarthest = 1e4;
constexpr double kFastest = 1e5;

/// ODE reports broken numbers through this handler and would abort the process after it returns.
[[noreturn]] void throw_diverged(int number, const char* format, va_list arguments) {
    std::array<char, 256> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    throw Diverged("ODE error " + std::to_string(number) + ": " + text.data());
}

void start_ode() {
    static const bool started = [] {
        dInitODE2(0);
        dAllocateODEDataForThread(dAllocateMaskAll);
        dSetDebugHandler(throw_diverged);
        dSetErrorHandler(throw_diverged);
        // ODE warns on singular matrices of single steps; a step that matters ends as Diverged.
        dSetMessageHandler([](int, const char*, va_list) {});
        return true;
    }();
    static_cast<void>(started);
}

/// One body under drag.
struct Damped {
    dBodyID body;
    double linear, angular;
};

/// A contact point found by collision, before its joint exists.
struct Found {
    dContact contact;
    dGeomID first, second;
    const Tag* a;
    const Tag* b;
};

const Tag* tag_of(dGeomID geom) { return static_cast<const Tag*>(dGeomGetData(geom)); }

dSurfaceParameters surface_parameters(const Tag& a, const Tag& b) {
    const Surface surface = mixed(*a.surface, *b.surface);
    dSurfaceParameters p{};
    p.mu = dInfinity;
    if (surface.bounce) {
        p.mode |= dContactBounce;
        p.bounce = *surface.bounce;
        p.bounce_vel = surface.bounce_velocity.value_or(0.0);
    }
    if (surface.slip) {
        p.mode |= dContactSlip1 | dContactSlip2;
        p.slip1 = p.slip2 = *surface.slip;
    }
    if (surface.soft_erp) {
        p.mode |= dContactSoftERP;
        p.soft_erp = *surface.soft_erp;
    }
    if (surface.soft_cfm) {
        p.mode |= dContactSoftCFM;
        p.soft_cfm = *surface.soft_cfm;
    }
    return p;
}

}  // namespace

struct World::Impl {
    dWorldID world = dWorldCreate();
    dJointGroupID contact_joints = dJointGroupCreate(0);
    std::vector<dSpaceID> groups;
    std::vector<Damped> bodies;
    std::vector<Found> found;
    std::vector<dJointFeedback> feedback;
    std::vector<Contact> contacts;

    void apply_drag() const;
    void collide();
    void collide_pair(dGeomID one, dGeomID other);
    void make_contact_joints();
    void collect_contacts();
    void check_finite() const;
};

void World::Impl::apply_drag() const {
    for (const Damped& d : bodies) {
        const dReal* v = dBodyGetLinearVel(d.body);
        const dReal* w = dBodyGetAngularVel(d.body);
        dBodyAddForce(d.body, -d.linear * v[0], -d.linear * v[1], -d.linear * v[2]);
        dBodyAddTorque(d.body, -d.angular * w[0], -d.angular * w[1], -d.angular * w[2]);
    }
}

void World::Impl::collide() {
    found.clear();
    for (std::size_t i = 0; i < groups.size(); ++i) {
        for (std::size_t j = i + 1; j < groups.size(); ++j) {
            dSpaceCollide2(reinterpret_cast<dGeomID>(groups[i]),
                           reinterpret_cast<dGeomID>(groups[j]), this,
                           [](void* self, dGeomID one, dGeomID other) {
                               static_cast<Impl*>(self)->collide_pair(one, other);
                           });
        }
    }
}

void World::Impl::collide_pair(dGeomID one, dGeomID other) {
    if (tag_of(one)->kind < tag_of(other)->kind) std::swap(one, other);
    if (dGeomGetBody(one) == nullptr && dGeomGetBody(other) == nullptr) return;
    std::array<dContactGeom, kMaxContactsPerPair> points;
    const int count = dCollide(one, other, kMaxContactsPerPair, points.data(), sizeof(points[0]));
    if (count == 0) return;
    const Tag* a = tag_of(one);
    const Tag* b = tag_of(other);
    const dSurfaceParameters surface = surface_parameters(*a, *b);
    for (int k = 0; k < count; ++k) {
        Found f{};
        f.contact.surface = surface;
        f.contact.geom = points[static_cast<std::size_t>(k)];
        f.first = one;
        f.second = other;
        f.a = a;
        f.b = b;
        found.push_back(f);
    }
}

void World::Impl::make_contact_joints() {
    feedback.resize(found.size());  // before any joint points into it
    for (std::size_t i = 0; i < found.size(); ++i) {
        const dJointID joint = dJointCreateContact(world, contact_joints, &found[i].contact);
        dJointAttach(joint, dGeomGetBody(found[i].first), dGeomGetBody(found[i].second));
        feedback[i] = {};
        dJointSetFeedback(joint, &feedback[i]);
    }
}

void World::Impl::collect_contacts() {
    contacts.clear();
    for (std::size_t i = 0; i < found.size(); ++i) {
        const dReal* p = found[i].contact.geom.pos;
        const dReal* f = feedback[i].f1;
        contacts.push_back({found[i].a, found[i].b, {p[0], p[1], p[2]}, {f[0], f[1], f[2]}});
    }
}

void World::Impl::check_finite() const {
    for (const Damped& d : bodies) {
        const dReal* p = dBodyGetPosition(d.body);
        const dReal* v = dBodyGetLinearVel(d.body);
        const dReal* w = dBodyGetAngularVel(d.body);
        for (int k = 0; k < 3; ++k) {
            // Written so that NaN is out of bounds, too.
            if (!(std::abs(p[k]) < kFarthest && std::abs(v[k]) < kFastest &&
                  std::abs(w[k]) < kFastest)) {
                throw Diverged("a body's state is out of bounds");
            }
        }
    }
}

World::World() {
    start_ode();
    impl_ = std::make_unique<Impl>();
    const dWorldID world = impl_->world;
    dWorldSetGravity(world, 0, 0, -kGravity);
    dWorldSetCFM(world, 1e-5);
    dWorldSetERP(world, 0.2);
    dWorldSetContactSurfaceLayer(world, 0.001);
    dWorldSetAutoDisableFlag(world, 1);
    dRandSetSeed(1);  // ODE's only randomness; global to the process
}

World::~World() {
    dJointGroupDestroy(impl_->contact_joints);
    for (const dSpaceID group : impl_->groups) dSpaceDestroy(group);
    dWorldDestroy(impl_->world);
}

dxWorld* World::ode() const { return impl_->world; }

dxSpace* World::add_group() {
    const dSpaceID group = dSimpleSpaceCreate(nullptr);
    impl_->groups.push_back(group);
    return group;
}

void World::remove_group(dxSpace* group) {
    std::erase(impl_->groups, group);
    dSpaceDestroy(group);
}

void World::add_body(dxBody* body, double linear, double angular) {
    impl_->bodies.push_back({body, linear, angular});
}

void World::remove_body(dxBody* body) {
    std::erase_if(impl_->bodies, [body](const Damped& d) { return d.body == body; });
}

void World::step() {
    impl_->apply_drag();
    impl_->collide();
    impl_->make_contact_joints();
    dWorldStep(impl_->world, kCycleSeconds);
    impl_->collect_contacts();
    dJointGroupEmpty(impl_->contact_joints);
    impl_->check_finite();
}

std::span<const Contact> World::contacts() const { return impl_->contacts; }

std::uint64_t World::hash(std::uint64_t previous) const {
    std::uint64_t hash = previous;
    for (const Damped& d : impl_->bodies) {
        std::array<double, 13> state{};
        const dReal* position = dBodyGetPosition(d.body);
        const dReal* rotation = dBodyGetQuaternion(d.body);
        const dReal* linear = dBodyGetLinearVel(d.body);
        const dReal* angular = dBodyGetAngularVel(d.body);
        std::copy_n(position, 3, state.begin());
        std::copy_n(rotation, 4, state.begin() + 3);
        std::copy_n(linear, 3, state.begin() + 7);
        std::copy_n(angular, 3, state.begin() + 10);
        hash = XXH3_64bits_withSeed(state.data(), sizeof(state), hash);
    }
    return hash;
}

}  // namespace k3d::server::physics
