// SPDX-License-Identifier: BSD-3-Clause
// The tuned kick; what it reached is noted in agent/config/kick.toml.
#include "agent/motion/kick/config.h"

#include <cmath>

namespace k3d::agent::kick {

Config::Config() {
    ball_forward = 0.17;
    ball_outward = 0.028;
    aim_outward_deg = 0;
    reach_forward = 0.03;
    reach_sideways = 0.025;
    reach_direction_deg = 12;

    far.reach_m = 6;
    far.duration_s = {0.28, 0.02, 0.02, 0.02, 0.18};
    far.kicking.hip_yaw_pitch_deg = {0, -17.4, 0, 0, 0};
    far.kicking.hip_roll_deg = {-17.1, -39.4, -11.6, 18.8, 0.7};
    far.kicking.hip_pitch_deg = {52.1, -11.7, 33.5, 99, 48};
    far.kicking.knee_deg = {-92.7, -14.3, -34.1, -58, -28};
    far.kicking.ankle_pitch_deg = {34.9, 70, 69.4, -10.7, -5.7};
    far.kicking.ankle_roll_deg = {-0.8, 7.4, -11.2, 3.4, 0.5};
    far.support.hip_yaw_pitch_deg = {-36.5, -9.7, -1.5, 0, 0};
    far.support.hip_roll_deg = {-22.4, 3, -17.5, -1.4, 28.8};
    far.support.hip_pitch_deg = {15.5, 28.8, 42.8, -23.4, 45.9};
    far.support.knee_deg = {-37.9, -30.3, -47.6, -20.8, -52.1};
    far.support.ankle_pitch_deg = {27.5, 54.3, 37.4, 16.1, 57.9};
    far.support.ankle_roll_deg = {15.4, 22, 17.5, 7.4, -11.1};
    far.stand_s = 0.3;

    near.reach_m = 3.3;
    near.duration_s = {0.22, 0.02, 0.02, 0.02, 0.16};
    near.kicking.hip_yaw_pitch_deg = {0, -17.9, 0, 0, 0};
    near.kicking.hip_roll_deg = {-21.4, -36, -10, 17.4, -1.1};
    near.kicking.hip_pitch_deg = {40.6, -12.8, 24.4, 99, 47.2};
    near.kicking.knee_deg = {-95.8, -20.4, -25.8, -55.1, -33.7};
    near.kicking.ankle_pitch_deg = {36.7, 70, 62.7, -13.8, -21.6};
    near.kicking.ankle_roll_deg = {0.2, 6.4, -7.8, 4.1, -3.6};
    near.support.hip_yaw_pitch_deg = {-25.2, -9.5, -10.7, 0, 0};
    near.support.hip_roll_deg = {-23.9, -1.3, -15.1, -8.5, 34.5};
    near.support.hip_pitch_deg = {17.9, 20.2, 22.4, -21.8, 39.7};
    near.support.knee_deg = {-41.5, -25.8, -40.9, -10.1, -53.6};
    near.support.ankle_pitch_deg = {23.8, 54.7, 45.5, 9.1, 49.7};
    near.support.ankle_roll_deg = {16.4, 17.4, 22.1, 8.9, -7};
    near.stand_s = 0.32;
}

const Swing& Config::swing_for(double distance) const {
    return std::abs(distance - near.reach_m) < std::abs(distance - far.reach_m) ? near : far;
}

}  // namespace k3d::agent::kick
