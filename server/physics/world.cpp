// SPDX-License-Identifier: BSD-3-Clause
// Sets the ODE world up, and leads from collision over the chosen stepper to the contacts.
#include "server/physics/world.h"

#include <ode/ode.h>
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <optional>
#include <utility>

#include "server/physics/collision.h"
#include "server/physics/exact_stepper.h"
#include "server/physics/fast/fast_stepper.h"

namespace k3d::server::physics {

namespace {

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

BodyState state_of(dBodyID body) {
    BodyState state{};
    std::copy_n(dBodyGetPosition(body), 3, state.begin());
    std::copy_n(dBodyGetQuaternion(body), 4, state.begin() + 3);
    std::copy_n(dBodyGetLinearVel(body), 3, state.begin() + 7);
    std::copy_n(dBodyGetAngularVel(body), 3, state.begin() + 10);
    return state;
}

void set_state_of(dBodyID body, const BodyState& s) {
    const dQuaternion rotation{s[3], s[4], s[5], s[6]};
    dBodySetPosition(body, s[0], s[1], s[2]);
    dBodySetQuaternion(body, rotation);
    dBodySetLinearVel(body, s[7], s[8], s[9]);
    dBodySetAngularVel(body, s[10], s[11], s[12]);
    dBodyEnable(body);
}

void check(dBodyID body) {
    const BodyState state = state_of(body);
    for (std::size_t k = 0; k < state.size(); ++k) {
        const double most = k < 7 ? kFarthest : kFastest;  // position and rotation, then velocities
        // Written so that NaN is out of bounds, too.
        if (!(std::abs(state[k]) < most)) throw Diverged("a body's state is out of bounds");
    }
}

dWorldID make_world() {
    start_ode();
    const dWorldID world = dWorldCreate();
    dWorldSetGravity(world, 0, 0, -kGravity);
    dWorldSetCFM(world, 1e-5);
    dWorldSetERP(world, 0.2);
    dWorldSetContactSurfaceLayer(world, 0.001);
    dWorldSetAutoDisableFlag(world, 1);
    dRandSetSeed(1);  // ODE's only randomness; global to the process
    return world;
}

struct DestroyWorld {
    void operator()(dxWorld* world) const { dWorldDestroy(world); }
};

}  // namespace

struct World::Impl {
    explicit Impl(Stepper kind) {
        if (kind == Stepper::Fast) fast.emplace(world.get());
    }

    std::unique_ptr<dxWorld, DestroyWorld> world{make_world()};  // outlives what is made in it
    Collision collision;
    std::vector<Mechanism> mechanisms;
    ExactStepper exact{world.get()};
    std::optional<fast::FastStepper> fast;  ///< steps in its place, if there
    std::uint64_t revision = 0;
    std::vector<Contact> contacts;

    template <class Visit>
    void each_body(Visit visit) const {
        for (const Mechanism& mechanism : mechanisms) {
            for (const dBodyID body : mechanism.bodies) visit(body);
        }
    }
};

World::World(Stepper stepper) : impl_(std::make_unique<Impl>(stepper)) {}
World::~World() = default;

dxWorld* World::ode() const {
    return impl_->world.get();
}

int World::add_group() {
    return impl_->collision.add_group();
}
void World::remove_group(int id) {
    impl_->collision.remove_group(id);
}
void World::add_geom(int group, dxGeom* geom) {
    impl_->collision.add_geom(group, geom);
}

void World::add_mechanism(Mechanism mechanism) {
    if (impl_->fast) impl_->fast->add(mechanism);
    impl_->mechanisms.push_back(std::move(mechanism));
}

void World::remove_mechanism(const dxBody* first) {
    if (impl_->fast) impl_->fast->remove(first);
    std::erase_if(impl_->mechanisms,
                  [first](const Mechanism& m) { return m.bodies.front() == first; });
}

void World::step(StageClock* stages) {
    if (stages != nullptr) stages->enter(Stage::Collision);
    const std::vector<Touch>& touches = impl_->collision.find();
    if (stages != nullptr) stages->enter(Stage::Physics);
    if (impl_->fast) {
        impl_->fast->step(touches, impl_->contacts);
    } else {
        impl_->exact.step(impl_->mechanisms, touches, impl_->contacts);
    }
    ++impl_->revision;
    impl_->each_body(check);
}

std::uint64_t World::revision() const {
    return impl_->revision;
}

std::span<const Contact> World::contacts() const {
    return impl_->contacts;
}

std::vector<BodyState> World::state() const {
    std::vector<BodyState> all;
    impl_->each_body([&all](dBodyID body) { all.push_back(state_of(body)); });
    return all;
}

void World::set_state(std::span<const BodyState> state) {
    ++impl_->revision;
    auto next = state.begin();
    impl_->each_body([&next](dBodyID body) { set_state_of(body, *next++); });
}

std::uint64_t World::hash(std::uint64_t previous) const {
    std::uint64_t hash = previous;
    impl_->each_body([&hash](dBodyID body) {
        const BodyState state = state_of(body);
        hash = XXH3_64bits_withSeed(state.data(), sizeof(state), hash);
    });
    return hash;
}

}  // namespace k3d::server::physics
