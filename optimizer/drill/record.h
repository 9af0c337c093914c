// SPDX-License-Identifier: BSD-3-Clause
// What is known of a drill afterwards: the truth, frame by frame, and beside it what the agent
// believed at the same game time. Field frame, metres, radians, seconds.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/math/geometry.h"
#include "optimizer/drill/scene.h"

namespace k3d::optimizer::drill {

/// One belief of the agent's telemetry.
struct Belief {
    Pose2 pose;
    bool localised = false;
    bool upright = true;
    std::string activity;
    int kicks = 0;
    struct Ball {
        Vec2 position = Vec2::Zero();
        Vec2 finish = Vec2::Zero();
        double seen = 0.0;  ///< s since own sight
    };
    std::optional<Ball> ball;
    std::optional<Vec2> target;
};

/// A moment of the drill. Velocities are over the frame before.
struct Moment {
    double time = 0.0;  ///< s since the drill began
    Truth truth;
    Vec2 ball_velocity = Vec2::Zero();
    std::optional<Belief> belief;  ///< none where the telemetry has none
};

/// Throws episode::TelemetryError naming file and line for damaged telemetry.
std::vector<Moment> join(const std::vector<Truth>& track, const std::string& telemetry_file);

}  // namespace k3d::optimizer::drill
