// SPDX-License-Identifier: BSD-3-Clause
#include "server/body/arena.h"

#include <ode/ode.h>

#include "common/field/field.h"

namespace k3d::server::body {

Arena::Arena(physics::World& world) {
    const int group = world.add_group();  // destroyed, with its geoms, by the world
    const dGeomID ground = dCreatePlane(nullptr, 0, 0, 1, 0);
    dGeomSetData(ground, &ground_);
    world.add_geom(group, ground);
    for (const field::SolidBox& box : field::solids()) {
        const dGeomID geom = dCreateBox(nullptr, box.size.x(), box.size.y(), box.size.z());
        dGeomSetPosition(geom, box.centre.x(), box.centre.y(), box.centre.z());
        dGeomSetData(geom, &solid_);
        world.add_geom(group, geom);
    }
}

}  // namespace k3d::server::body
