// SPDX-License-Identifier: BSD-3-Clause
// What the agent believes about the game: the plain structs between world/ and decision/.
//
// Frame: TEAM frame, that is the field frame of common/field for the left team and the same turned
// by 180 degrees for the right team (x towards the opponents' goal). Metres, radians, seconds of
// simulated time. Every estimate comes from the wire alone.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/math/geometry.h"
#include "common/wire/percepts.h"

namespace k3d::agent::world {

struct Self {
    Pose2 pose;                  ///< of the torso, on the ground
    double position_sd = 1e9;    ///< m, spread of the estimate
    double yaw_sd = 1e9;         ///< rad
    bool localised = false;      ///< spread small enough to act on
    bool upright = true;
};

struct Ball {
    bool known = false;          ///< seen or heard of within the memory time
    double seen = -1e9;          ///< when last seen by this agent's own eyes
    Vec2 position = Vec2::Zero();
    Vec2 velocity = Vec2::Zero();
    /// Predicted stopping point (paper 3.2); the position itself while the ball is at rest.
    Vec2 finish = Vec2::Zero();
    Vec2 position_before = Vec2::Zero();  ///< the ball 0.5 s ago (paper-notes: prev_ball)
    bool moving = false;
};

struct Player {
    int unum = 0;
    bool mate = false;
    double seen = -1e9;          ///< when last seen or heard of
    double eyes = -1e9;          ///< when last seen by this agent's own eyes
    Vec2 position = Vec2::Zero();
    Vec2 velocity = Vec2::Zero();
    Vec2 lagged = Vec2::Zero();  ///< exponentially discounted mean position, taker_hat of paper 5.3
    bool fallen = false;
};

struct Game {
    std::string play_mode;       ///< names of reference 7.1
    double time = 0.0;           ///< game time, s
    wire::Side side = wire::Side::None;
    int unum = 0;
};

struct Beliefs {
    double now = 0.0;            ///< simulation time `now` of the frame
    Self self;
    Ball ball;
    std::vector<Player> mates;      ///< without this agent itself; by unum
    std::vector<Player> opponents;  ///< by unum
    Game game;
};

}  // namespace k3d::agent::world
