// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/spec/figures.h"

#include <algorithm>

#include "optimizer/spec/task_spec.h"

namespace k3d::optimizer::spec {

namespace {

using Names = std::vector<std::string>;

void add(Names& names, const Names& more) {
    names.insert(names.end(), more.begin(), more.end());
}

/// Of a prediction of where the ball stops, as the drills name them.
void add_finish_errors(Names& names, const std::string& of) {
    for (const char* after : {"0.2", "0.5", "1.0", "1.5", "2.0", "3.0"}) {
        names.push_back(of + "_error_" + after + "s_m");
    }
    names.push_back(of + "_loss");
}

/// What only this drill measures.
Names measured_by(std::string_view drill) {
    if (drill == "walk") return {"speed_mps", "distance_m", "drift_m", "turned_deg"};
    if (drill == "turn") return {"turn_deg_per_s", "drift_m"};
    if (drill == "go_to") {
        return {"speed_to_target_mps", "targets", "reached", "falls_per_10_min"};
    }
    if (drill == "kick_task") {
        Names names{"fitness_capped", "fitness_literal", "succeeded", "time_to_kick_s",
                    "distance_m", "direction_error_deg", "within_1m_of_wanted", "target_error_m"};
        add_finish_errors(names, "finish");
        return names;
    }
    Names names{"rolled_m", "ball_speed_mps", "kicked_height_m"};  // ball_rolls
    add_finish_errors(names, "finish");
    add_finish_errors(names, "kicked");
    return names;
}

}  // namespace

std::vector<std::string> figures_of(std::string_view task) {
    Names names{"hold_time_s", "attempts", "kicks", "passes_completed", "falls"};
    if (const std::string_view drill = drill_of(task); drill.empty()) {
        names.push_back("side_m");
    } else {
        add(names, {"simulated_s", "position_error_m", "position_error_95_m", "yaw_error_deg",
                    "ball_error_percent"});
        add(names, measured_by(drill));
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace k3d::optimizer::spec
