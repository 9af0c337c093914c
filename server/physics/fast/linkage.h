// SPDX-License-Identifier: BSD-3-Clause
// One mechanism in the fast stepper: links, hinges, and what they are worth to the solver in a
// step. Symbols and frames: fast_stepper.h.
#pragma once

#include <ode/ode.h>

#include <cstdint>
#include <vector>

#include "common/math/geometry.h"
#include "server/physics/fast/hinge.h"
#include "server/physics/mechanism.h"

namespace k3d::server::physics::fast {

/// What is the same for all mechanisms of a world.
struct Settings {
    Vec3 gravity;
    double erp;  ///< of hinges
    double cfm;  ///< of contact rows whose surface has none
    double surface_layer;
};

struct Twist {
    Vec3 linear = Vec3::Zero();  ///< of the centre of mass
    Vec3 angular = Vec3::Zero();
};

/// Mass, first moment and inertia about the base.
struct Composite {
    double mass = 0.0;
    Vec3 moment = Vec3::Zero();
    Mat3 inertia = Mat3::Zero();
};

/// A wrench times h, or a momentum, about the base.
struct Wrench {
    Vec3 linear = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
    Wrench& operator+=(const Wrench& other) {
        linear += other.linear;
        angular += other.angular;
        return *this;
    }
};

class Linkage;

/// Where a body stands: kept as the user data of the ODE body.
struct Place {
    Linkage* linkage;
    std::size_t link;
};

/// Constants of a link. ODE's memory of the body is read in place: its pointers stay valid.
struct Link {
    dBodyID body;
    const dReal* position;
    const dReal* rotation;    ///< rows of 4
    const dReal* quaternion;  ///< w, x, y, z
    const dReal* linear;
    const dReal* angular;
    double mass;
    Vec3 inertia;        ///< principal moments, along the link's own axes
    bool round;          ///< they are equal
    std::size_t parent;  ///< of the base: itself
    std::uint64_t path;  ///< bit per link from the base to this one
};

struct LinkState {
    Mat3 rotation;
    Vec3 offset;         ///< d_i
    Mat3 inertia;        ///< I_i
    Vec3 free_momentum;  ///< m_i v_i*
    Vec3 free_spin;      ///< I_i w_i*
    Twist bias;          ///< twist if the base stood still and released hinges too
    Twist twist;         ///< new
    Wrench push;         ///< sum of contact impulses
};

class Linkage {
  public:
    Linkage(const Mechanism& mechanism, const Settings& settings);
    Linkage(const Linkage&) = delete;
    Linkage& operator=(const Linkage&) = delete;

    const dxBody* first_body() const { return links_.front().body; }

    /// Reads the state from ODE; all hinges are held.
    void read();
    /// Advances ODE's bodies by the new twists, as dWorldStep does.
    void write() const;

    // The unknowns: base twist, then the rates of released hinges.
    std::size_t columns() const { return 6 + released_.size(); }
    /// Adds the inertia to the lower triangle of `matrix` (rows of `stride`), from `column` on.
    void add_inertia(double* matrix, std::size_t stride) const;
    /// Adds the momentum that the unknowns must carry, from `column` on.
    void add_momentum(double* right) const;
    /// Row of the velocity along `direction` of the point at `offset` from the base on a link.
    void jacobian(std::size_t link, const Vec3& offset, const Vec3& direction, double* row) const;

    /// Offset from the base of a point in the field frame that is on the link.
    Vec3 offset_of(std::size_t link, const Vec3& point) const;
    Vec3 old_velocity(std::size_t link, const Vec3& point) const;   ///< of ODE's state
    Vec3 bias_velocity(std::size_t link, const Vec3& point) const;  ///< under LinkState::bias

    // After a solution of the unknowns.
    void take_solution(const double* unknowns);  ///< twists of all links; clears the pushes
    void push(std::size_t link, const Vec3& offset, const Vec3& impulse);
    /// Finds the hinges' torques and moves hinges between held and released where bounds ask for
    /// it: all that must, or `one_only`. True if one moved: the system is to be solved again.
    bool release_hinges(bool one_only);
    /// Lets the hinges yield to the forces that release_hinges() found in them. The system is to be
    /// solved again.
    void yield_to_forces();

    std::size_t island = 0;  ///< label while islands are gathered
    std::size_t column = 0;  ///< where its unknowns begin in the system of its island

  private:
    void add_link(dBodyID body);
    void add_hinge(dJointID joint, std::size_t link);
    void read_link(std::size_t i);
    void read_hinge(std::size_t i);
    void set_bias();
    /// Twists of all links from that of the base and the hinges' rates.
    void propagate(const Twist& base, Twist LinkState::*out);
    void sum_to_base(std::vector<Wrench>& wrenches) const;

    Settings settings_;
    double linear_drag_, angular_drag_;
    std::vector<Link> links_;
    std::vector<Place> places_;
    std::vector<LinkState> states_;
    std::vector<Hinge> hinges_;  ///< by link; the base's is empty
    std::vector<std::size_t> released_;
    // Of the subtree that begins with each link.
    std::vector<Composite> below_;
    std::vector<Wrench> missing_;  ///< momentum that bias leaves for the unknowns to carry
    std::vector<Wrench> carried_;  ///< impulse that the hinge above must transmit
};

}  // namespace k3d::server::physics::fast
