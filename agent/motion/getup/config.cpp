// SPDX-License-Identifier: BSD-3-Clause
// The tuned get-up; what it reached is noted in agent/config/getup.toml.
#include "agent/motion/getup/config.h"

namespace k3d::agent::getup {

Config::Config() {
    back.duration_s = {0.2, 0.08, 0.24, 0.08};
    back.shoulder_pitch_deg = {100, 45.1, 72.7, -10.4};
    back.shoulder_spread_deg = {27.2, 67.6, 94, 21.6};
    back.hip_yaw_pitch_deg = {-40.4, -49.5, -79.3, -25.5};
    back.hip_roll_deg = {13.3, 4.2, -23.1, 35.9};
    back.hip_pitch_deg = {88.2, 69, 98.3, -2.9};
    back.knee_deg = {0, -64.1, -83.4, -128.2};
    back.ankle_deg = {62.4, -12.2, -28.2, 35.7};
    back.stand_s = 0.1;
    front.duration_s = {0.28, 0.18, 0.22, 0.12};
    front.shoulder_pitch_deg = {65.5, 30.7, -58.7, -32.2};
    front.shoulder_spread_deg = {9.5, 26.5, 9, 2.2};
    front.hip_yaw_pitch_deg = {-39.6, -89, -89, -14.4};
    front.hip_roll_deg = {16.2, 44, 22.8, -8.3};
    front.hip_pitch_deg = {-21.8, 74.2, 98.1, 99};
    front.knee_deg = {-64.8, -95.5, -115.4, -126.8};
    front.ankle_deg = {50.2, 15.9, -10.3, 42.1};
    front.stand_s = 0.18;
}

}  // namespace k3d::agent::getup
