// SPDX-License-Identifier: BSD-3-Clause
// The tuned kick; what it reached is noted in agent/config/kick.toml.
#include "agent/motion/kick/config.h"

#include <algorithm>
#include <cmath>

namespace k3d::agent::kick {

Config::Config() {
    ball_forward = 0.167;
    ball_outward = 0.033;
    aim_outward_deg = 0;
    reach_forward = 0.025;
    reach_sideways = 0.045;
    reach_direction_deg = 12;

    far.reach_m = 5.8;
    far.duration_s = {0.24, 0.02, 0.02, 0.02, 0.18};
    far.kicking.hip_yaw_pitch_deg = {-0.1, -20, -1.3, 0, 0};
    far.kicking.hip_roll_deg = {-15.5, -38.8, -7.5, 14.6, -0.3};
    far.kicking.hip_pitch_deg = {51.1, -7.6, 19.3, 99, 48.1};
    far.kicking.knee_deg = {-89.6, -9.6, -33.4, -57.6, -21.4};
    far.kicking.ankle_pitch_deg = {25.9, 67.1, 70, -0.1, -14.6};
    far.kicking.ankle_roll_deg = {-0.9, 5.6, -8.7, 1.4, -1.8};
    far.support.hip_yaw_pitch_deg = {-37, -15.4, -12.4, 0, 0};
    far.support.hip_roll_deg = {-20, 3.9, -19.4, -1.9, 24.9};
    far.support.hip_pitch_deg = {4.6, 26.1, 52.3, -24, 48.8};
    far.support.knee_deg = {-33.2, -30.6, -45.5, -29.6, -53.2};
    far.support.ankle_pitch_deg = {23.5, 47.8, 41.2, 25.7, 52.5};
    far.support.ankle_roll_deg = {17.2, 22.4, 13.2, 10.7, -8.6};
    far.stand_s = 0.3;

    near.reach_m = 3.6;
    near.duration_s = {0.22, 0.02, 0.02, 0.02, 0.14};
    near.kicking.hip_yaw_pitch_deg = {0, -19.6, -1.6, 0, 0};
    near.kicking.hip_roll_deg = {-21.2, -35.3, -11.5, 18.5, -1.9};
    near.kicking.hip_pitch_deg = {43.9, -10, 20.3, 99, 51.8};
    near.kicking.knee_deg = {-98.9, -17.9, -26.5, -58.7, -33.4};
    near.kicking.ankle_pitch_deg = {39.6, 70, 58.3, -14.2, -12.9};
    near.kicking.ankle_roll_deg = {2, 5.3, -3.4, 2.3, -3.7};
    near.support.hip_yaw_pitch_deg = {-23.7, -6.8, -5.4, 0, 0};
    near.support.hip_roll_deg = {-23.1, -2.2, -12.9, -8.5, 34.2};
    near.support.hip_pitch_deg = {15.6, 17, 22.2, -24, 40};
    near.support.knee_deg = {-43.8, -26.4, -45.2, -12.4, -53.5};
    near.support.ankle_pitch_deg = {24.5, 53.5, 45.9, 4.4, 46.6};
    near.support.ankle_roll_deg = {14, 18.3, 20.7, 6.2, -9};
    near.stand_s = 0.32;
}

double Config::far_share(double distance) const {
    if (distance >= far.reach_m) return 1.0;
    if (distance <= near.reach_m) return 0.0;
    // Measured: the first steps from near to far bring the most.
    return 1.0 - std::sqrt((far.reach_m - distance) / (far.reach_m - near.reach_m));
}

double Config::reach_for(double distance) const {
    return std::max(std::min(distance, far.reach_m), near.reach_m);
}

}  // namespace k3d::agent::kick
