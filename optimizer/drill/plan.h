// SPDX-License-Identifier: BSD-3-Clause
// One drill as a plan: what the agent is told, what the trainer does, what is measured afterwards.
// The plans of one folder file each stand in their own source file.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "common/random/stream.h"
#include "optimizer/drill/record.h"
#include "optimizer/drill/stage.h"
#include "optimizer/spec/drill_spec.h"

namespace k3d::optimizer::drill {

/// What came of it. A metric that a run does not have is left out of its table's n.
struct Measured {
    std::string reason;  ///< one word: "done", "fell", "no_kick", ...
    std::map<std::string, double> metrics;
};

struct Plan {
    std::vector<std::string> agent_settings;
    std::vector<std::string> second_settings;  ///< of a second robot of ours; empty: there is none
    std::function<void(Stage&)> act;  ///< from begin() on
    std::function<Measured(const std::vector<Moment>&)> measure;
};

/// `random` draws the set-up; `index` counts the runs from 0.
Plan plan_walk(const spec::DrillSpec& spec, int index, RandomStream& random);
Plan plan_turn(const spec::DrillSpec& spec, int index, RandomStream& random);
Plan plan_go_to(const spec::DrillSpec& spec, int index, RandomStream& random);
Plan plan_localise(const spec::DrillSpec& spec, int index, RandomStream& random);
Plan plan_get_up(const spec::DrillSpec& spec, int index, RandomStream& random);
Plan plan_kick(const spec::DrillSpec& spec, int index, RandomStream& random);
Plan plan_kick_task(const spec::DrillSpec& spec, int index, RandomStream& random);
Plan plan_intercept(const spec::DrillSpec& spec, int index, RandomStream& random);
Plan plan_ball_rolls(const spec::DrillSpec& spec, int index, RandomStream& random);

/// The plan of spec.name.
Plan plan(const spec::DrillSpec& spec, int index, RandomStream& random);

// What plans share.

/// Where a ball is out of everybody's way.
wire::BallCommand ball_away();
wire::BallCommand ball_at(const Vec2& position, const Vec2& velocity = Vec2::Zero());
/// The torso is tilted so far that the robot lies, or will.
bool is_down(const Truth& truth);
int count_falls(const std::vector<Moment>& moments);
/// Errors of the agent's estimates, measured in every drill: of its pose while upright, and of the
/// ball while it is in view and less than 6 m away.
void add_estimate_errors(const std::vector<Moment>& moments, Measured& out);
/// Errors of the predicted stopping point some seconds of rolling from `from` on to where the ball comes
/// to rest, as metrics whose names begin with `name`, and the paper's loss (3.2), mean over the sights.
void add_finish_errors(const std::vector<Moment>& moments, std::size_t from, const char* name,
                       Measured& out);
/// The ball lies still, or nearly.
bool is_at_rest(const Vec2& ball_velocity);

}  // namespace k3d::optimizer::drill
