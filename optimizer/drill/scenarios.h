// SPDX-License-Identifier: BSD-3-Clause
// The kick task of paper 3.1: fixed episodes in which the ball comes from the field's centre with
// some velocity and is to be kicked at a target. Three disjoint tables of twelve, so that no
// parameter is judged by what it was tuned on. Field frame, m, m/s.
#pragma once

#include <string>

#include "common/math/geometry.h"
#include "optimizer/spec/task_spec.h"

namespace k3d::optimizer::drill {

inline constexpr int kScenarios = spec::kKickScenarios;

struct Scenario {
    Pose2 robot;         ///< where it waits
    Vec2 ball_velocity;  ///< of the ball at the centre
    Vec2 target;
};

/// Scenario `index` modulo twelve of the table train, validation or test. Aborts on another name.
Scenario scenario_of(const std::string& table, int index);

}  // namespace k3d::optimizer::drill
