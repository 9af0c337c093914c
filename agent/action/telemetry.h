// SPDX-License-Identifier: BSD-3-Clause
// What the agent believes and decides, as JSON lines for those who know the truth.
//
// Every line is an object with "time", the server's `now` in s, and "event":
//   start         team, unum
//   belief        every belief_interval: game_time, mode, pose (x, y, yaw_deg, sd, yaw_sd_deg, localised),
//                 upright, activity, falls, kicks, ball (x, y, vx, vy, finish_x, finish_y,
//                 seen = s since own sight) or null, role, skill, k1, k2, target (x, y) or null,
//                 cost, taker_distance; with telemetry_targets scored, a list of [x, y, cost]
//   kick_attempt  a kick motion begins: robot, ball and target
//   kick_end      it is over
//   fall, got_up
//   role          a new role: from, to
// Positions are in the absolute field frame (common/field), metres and degrees, for both teams.
#pragma once

#include <fstream>
#include <string>

#include "agent/decision/decision.h"
#include "agent/motion/motion.h"
#include "agent/world/beliefs.h"

namespace k3d::agent::action {

class Telemetry {
  public:
    /// Writes nothing if `path` is empty. Throws std::invalid_argument if the file cannot be
    /// opened, with the reason. Each line goes out whole, so that a killed agent leaves no half of
    /// one.
    /// `targets`: beliefs tell all targets that K1 has scored.
    Telemetry(const std::string& path, const std::string& team, double belief_interval,
              bool targets = false);

    /// Once a cycle. Throws std::runtime_error if a line cannot be written, when the disk is full,
    /// say: who counts kick attempts must not take a file that ends early for a match without any.
    void record(const world::Beliefs& beliefs, const motion::State& body,
                const decision::Decision& decision);

  private:
    std::string path_;
    std::ofstream file_;
    std::string team_;
    double belief_interval_;
    bool targets_;
    bool started_ = false;
    double next_belief_ = 0.0;
    bool upright_ = true;
    int kicks_ = 0;
    std::string role_;
};

}  // namespace k3d::agent::action
