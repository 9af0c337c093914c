// SPDX-License-Identifier: BSD-3-Clause
// Finds the contact points of a step: ODE's collision functions over pairs of groups of geoms.
#pragma once

#include <ode/ode.h>

#include <array>
#include <vector>

#include "server/physics/world.h"

namespace k3d::server::physics {

/// A contact point before it is solved; the first geom is a's.
struct Touch {
    dContact contact;  ///< point, normal towards a, depth, mixed surface
    const Tag* a;
    const Tag* b;
    dBodyID body_a;  ///< never null
    dBodyID body_b;  ///< null: it stands still
};

using Bounds = std::array<dReal, 6>;  ///< x, y, z as (low, high), field frame

class Collision {
  public:
    Collision() = default;
    ~Collision();
    Collision(const Collision&) = delete;
    Collision& operator=(const Collision&) = delete;

    int add_group();
    void remove_group(int id);  ///< destroys its geoms
    void add_geom(int group, dGeomID geom);

    /// All touches between groups, in order of the groups' and of their geoms' addition.
    const std::vector<Touch>& find();

  private:
    struct Shape {
        dGeomID geom;
        Bounds bounds;
    };
    struct Group {
        int id;
        std::vector<Shape> shapes;
        Bounds bounds;  ///< of all shapes
        void bound();
    };

    std::vector<Group>::iterator find_group(int id);
    void collide_groups(const Group& one, const Group& other);
    void collide_pair(dGeomID one, dGeomID other);

    std::vector<Group> groups_;
    std::vector<Touch> found_;
    int next_id_ = 0;
};

}  // namespace k3d::server::physics
