// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the walk. Lengths are those of a robot with type 0's legs; the engine scales them
// by leg length. Defaults are the tuned values of agent/config/walk.toml.
#pragma once

#include <vector>

#include "common/config/fields.h"

namespace k3d::agent::motion::walk {

struct Config {
    // Limits of what may be asked.
    double max_forward = 0.85;
    double max_backward = 0.54;
    double max_sideways = 0.33;
    double max_turn = 2.6;
    double forward_acceleration = 1.2;
    double sideways_acceleration = 0.8;
    double turn_acceleration = 4.11;
    double braking = 1.2;

    double forward_scale = 1.0;
    double forward_slip = 0.062;
    double sideways_scale = 1.12;
    double turn_scale = 1.0;
    double heading_gain = 3.0;

    double combined = 1.0;
    double brisk_combined = 1.1;
    // By robot type: top speeds and accelerations, and the time of a step, over those of type 0.
    std::vector<double> type_speed{1.0, 1.02, 0.9, 1.1, 1.0};
    std::vector<double> type_step_duration{1.0, 1.0, 1.143, 1.0, 1.0};

    // The step.
    double step_duration = 0.14;
    double lift_start = 0.05184;
    double lift_end = 0.96;
    double step_height = 0.018;
    double step_height_gain = 0.01;
    double lift_shape = 0.4795;
    double landing_match = 0.0;
    double swing_ease = 0.3491;

    // The stance.
    double crouch = 0.04398;
    double spread = 0.0;
    double foot_forward = 0.0;
    double foot_forward_gain = 0.02;
    double lean = 0.08;
    double lean_gain = 0.05;
    double sway = 0.001278;
    double sway_phase = -0.1917;
    double toe_up = -0.1156;

    // Balance: which share of the torso's tilt error the legs take up, and the steps.
    double pitch_lead = 0.03;
    double roll_lead = 0.02461;
    double support_pitch = 0.0;
    double support_roll = 0.0;
    double support_turn_pitch = 0.0;
    double support_turn_roll = 0.1617;
    double swing_pitch = 0.5934;
    double swing_roll = 0.5;
    double swing_turn_pitch = 0.8;
    double swing_turn_roll = 0.6392;
    double step_forward = 0.02172;
    double step_forward_rate = 0.001489;
    double step_sideways = 0.0616;
    double step_sideways_rate = 0.01;

    // The arms.
    double shoulder_pitch = -1.9;
    double shoulder_yaw = 0.2;
    double arm_roll = 1.57;
    double elbow = 0.9;
    double arm_swing = -0.0696;

    void describe(config::Fields& f);
};

}  // namespace k3d::agent::motion::walk
