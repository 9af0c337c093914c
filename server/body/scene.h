// SPDX-License-Identifier: BSD-3-Clause
// Everything physical of one episode: world, arena, ball and the players' robots.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/wire/percepts.h"
#include "server/body/arena.h"
#include "server/body/ball.h"
#include "server/body/robot.h"
#include "server/physics/world.h"

namespace k3d::server::body {

/// A robot with its place in a team.
struct Player {
    int id = 0;                              ///< tags its contacts; unique in a scene
    wire::Side team = wire::Side::None;
    int unum = 0;
    std::string team_name;
    bool selected = false;                   ///< by a trainer: marked for monitors, acted on by some commands
    std::unique_ptr<Robot> robot;

    /// "left.3", the name of its random streams.
    std::string entity() const;
};

/// Declared in the order in which parts depend on the world; players go before the world does.
struct Scene {
    explicit Scene(physics::Stepper stepper = physics::Stepper::Exact) : world(stepper) {}

    physics::World world;
    Arena arena{world};
    Ball ball{world};
    std::vector<std::unique_ptr<Player>> players;  ///< robots are stepped in this order

    Player& add_player(int type, const Vec3& torso);
    void remove_player(int id);
    Player* find(int id) const;  ///< null if there is none, or no longer
    Player* find(wire::Side team, int unum) const;

  private:
    int next_id_ = 0;
};

/// Field frame <-> a team's frame: the right team sees the field turned by 180 degrees.
inline Vec3 flipped(const Vec3& v, wire::Side team) {
    return team == wire::Side::Right ? Vec3(-v.x(), -v.y(), v.z()) : v;
}

}  // namespace k3d::server::body
