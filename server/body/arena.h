// SPDX-License-Identifier: BSD-3-Clause
// What stands still: the ground plane, the walls and the goals (reference 6.4).
#pragma once

#include <vector>

#include "server/physics/world.h"

namespace k3d::server::body {

class Arena {
  public:
    explicit Arena(physics::World& world);

  private:
    physics::Tag ground_{&physics::kGround, physics::Kind::Ground, 0, nao::Part::Torso};
    physics::Tag solid_{&physics::kSolidSurface, physics::Kind::Solid, 0, nao::Part::Torso};
};

}  // namespace k3d::server::body
