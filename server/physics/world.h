// SPDX-License-Identifier: BSD-3-Clause
// The ODE world as the reference server sets it up: gravity, drag, collision pairs, contact
// mixing and one exact step of 20 ms (reference 2.1, 5.5).
//
// Frame: field frame, metres, kilograms, seconds, newtons.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>

#include "common/math/geometry.h"
#include "common/nao/model.h"

// ODE's own types, so that its headers stay inside server/physics and server/body.
struct dxWorld;
struct dxSpace;
struct dxGeom;
struct dxBody;

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
    int owner = 0;                        ///< robot's id, 0 for the others
    nao::Part part = nao::Part::Torso;    ///< of a robot
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

class World {
  public:
    World();
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    dxWorld* ode() const;

    /// A set of geoms that never collide with one another. Groups are paired in order of creation,
    /// which fixes the order of contacts.
    dxSpace* add_group();
    void remove_group(dxSpace* group);

    /// Damps the body by force -linear*v and torque -angular*w each step (reference 5.5).
    void add_body(dxBody* body, double linear, double angular);
    void remove_body(dxBody* body);

    /// Drag, collision, one exact step of 20 ms. Throws Diverged.
    void step();

    std::span<const Contact> contacts() const;  ///< of the last step

    /// Hash of all positions, rotations and velocities, chained to `previous`.
    std::uint64_t hash(std::uint64_t previous) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace k3d::server::physics
