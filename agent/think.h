// SPDX-License-Identifier: BSD-3-Clause
// One agent's mind: a percept frame in, a command frame out. The stages stand in think.cpp in the
// order the data flows.
#pragma once

#include <string>
#include <string_view>

#include "agent/action/telemetry.h"
#include "agent/config.h"
#include "agent/decision/player.h"
#include "agent/motion/body_motion.h"
#include "agent/talk/ears.h"
#include "agent/world/world_model.h"
#include "common/wire/commands.h"
#include "common/wire/percepts.h"

namespace k3d::agent {

struct Seat {
    std::string team;
    int unum = 0;  ///< asked for; the server's word counts
};

class Mind {
  public:
    /// Throws network::NetworkError and std::invalid_argument for files that cannot be used.
    Mind(const Config& config, const Seat& seat, const std::string& telemetry_file);

    /// Reads one percept payload and writes the payload of the reply.
    void think(std::string_view payload, std::string& reply);

    /// None until the server has given this agent a place in a team.
    wire::Side side() const { return world_.beliefs().game.side; }

  private:
    const Config config_;
    Seat seat_;
    const nao::Model& model_;
    wire::Percepts percepts_;
    motion::BodySense sense_;
    motion::BodyMotion motion_;
    talk::Ears ears_;
    world::WorldModel world_;
    decision::Player player_;
    nao::JointArray rates_{};
    wire::Commands commands_;
    std::string unsaid_;  ///< the memory of the say text between turns
    action::Telemetry telemetry_;
};

}  // namespace k3d::agent
