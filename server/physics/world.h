// SPDX-License-Identifier: BSD-3-Clause
// The world as the reference server sets it up: gravity, drag, collision pairs, contact mixing and
// one step of 20 ms (reference 2.1, 5.5), by one of two steppers.
//
// Frame: field frame, metres, kilograms, seconds, newtons.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "common/clock/stage_clock.h"
#include "common/math/geometry.h"
#include "common/nao/model.h"
#include "server/physics/mechanism.h"

// ODE's own types, so that its headers stay inside server/physics and server/body.
struct dxWorld;
struct dxGeom;

namespace k3d::server::physics {

/// What a material does in a contact; an absent value leaves the choice to the other side.
struct Surface {
    std::optional<double> bounce{};
    std::optional<double> bounce_velocity{};
    std::optional<double> slip{};
    std::optional<double> soft_erp{};
    std::optional<double> soft_cfm{};
};

/// The materials of reference 5.5.
extern const Surface kGround, kRobotSurface, kBallSurface, kSolidSurface;

/// Both sides' values: the mean where both have one, else the one there is.
Surface mixed(const Surface& a, const Surface& b);

/// Whose geom it is. A contact lists the higher kind first.
enum class Kind : std::uint8_t { Ground, Solid, Ball, Robot };

struct Tag {
    const Surface* surface = nullptr;
    Kind kind = Kind::Ground;
    int owner = 0;                      ///< robot's id, 0 for the others
    nao::Part part = nao::Part::Torso;  ///< of a robot
};

/// A contact point of the last step, a.kind >= b.kind.
struct Contact {
    const Tag* a;
    const Tag* b;
    Vec3 point;
    Vec3 force_on_a;  ///< N, from the solver
};

/// The step produced or met numbers that are not finite or beyond any match; the episode is void.
class Diverged : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// How the velocities after a step are found: by ODE's dWorldStep, or by our own solver of the same
/// equations, which needs a small part of its time (fast/fast_stepper.h says how they differ).
enum class Stepper : std::uint8_t { Exact, Fast };

/// Pose and velocity of one body: position, quaternion (w, x, y, z), velocity, angular velocity.
using BodyState = std::array<double, 13>;

class World {
  public:
    explicit World(Stepper stepper = Stepper::Exact);
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    dxWorld* ode() const;

    /// A set of geoms that never collide with one another; returns its id. Groups and the geoms in
    /// them are paired in order of addition, which fixes the order of contacts.
    int add_group();
    void remove_group(int id);  ///< destroys its geoms
    /// A geom made without an ODE space; its data is a Tag that outlives it.
    void add_geom(int group, dxGeom* geom);

    /// From now on stepped, damped and hashed, in order of addition.
    void add_mechanism(Mechanism mechanism);
    /// The mechanism with this first body; before its bodies and hinges are destroyed.
    void remove_mechanism(const dxBody* first);

    /// Collision, drag, one step of 20 ms. Throws Diverged. `stages` is told what begins.
    void step(StageClock* stages = nullptr);

    std::span<const Contact> contacts() const;  ///< of the last step

    /// Another number after each step() and set_state(): what was worked out of bodies is out of date then.
    std::uint64_t revision() const;

    /// State of all bodies, in order of addition; with the hinges' motors it is all that a step
    /// needs.
    std::vector<BodyState> state() const;
    /// Sets what state() of a world with the same mechanisms returned.
    void set_state(std::span<const BodyState> state);

    /// Hash of all positions, rotations and velocities, chained to `previous`.
    std::uint64_t hash(std::uint64_t previous) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace k3d::server::physics
