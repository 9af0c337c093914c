// SPDX-License-Identifier: BSD-3-Clause
// The tuned get-up; what it reached is noted in agent/config/getup.toml.
#include "agent/motion/getup/config.h"

namespace k3d::agent::getup {

namespace {

Sequences type_0() {
    Sequences s;
    s.back.duration_s = {0.2, 0.08, 0.22, 0.06};
    s.back.shoulder_pitch_deg = {70.4, 119, 47.6, -22.5};
    s.back.shoulder_spread_deg = {11.6, 37.3, 91.4, 31};
    s.back.hip_yaw_pitch_deg = {-48.4, -76.9, -89, -0.7};
    s.back.hip_roll_deg = {13.7, -10.3, -22.7, 32.8};
    s.back.hip_pitch_deg = {99, 48.4, 99, -17.9};
    s.back.knee_deg = {-0.5, -129, -107.3, -95.7};
    s.back.ankle_deg = {63.3, -13.5, -25.3, 53.6};
    s.back.stand_s = 0.3;
    s.front.duration_s = {0.34, 0.06, 0.32, 0.16};
    s.front.shoulder_pitch_deg = {62.8, 15.8, -44.3, 0.2};
    s.front.shoulder_spread_deg = {8.3, 0, 13.1, 9.4};
    s.front.hip_yaw_pitch_deg = {-9.3, -89, -89, -22.9};
    s.front.hip_roll_deg = {0.5, 42, 34.7, 23.5};
    s.front.hip_pitch_deg = {-4.5, 88.6, 99, 99};
    s.front.knee_deg = {-48.7, -76.7, -90.5, -114.4};
    s.front.ankle_deg = {74, 36.5, -26.9, 30.3};
    s.front.stand_s = 0.3;
    return s;
}

Sequences type_1() {
    Sequences s;
    s.back.duration_s = {0.18, 0.1, 0.26, 0.08};
    s.back.shoulder_pitch_deg = {82.2, 119, 1.6, 5};
    s.back.shoulder_spread_deg = {0, 17.9, 60, 28.8};
    s.back.hip_yaw_pitch_deg = {-20.2, -54.1, -89, -25.4};
    s.back.hip_roll_deg = {24.5, -1.4, -24, 24.5};
    s.back.hip_pitch_deg = {84.9, 99, 99, 11.5};
    s.back.knee_deg = {0, -116.9, -114.7, -90.4};
    s.back.ankle_deg = {28.7, -43.6, -25.1, 35};
    s.back.stand_s = 0.36;
    s.front.duration_s = {0.6, 0.3, 0.34, 0.34};
    s.front.shoulder_pitch_deg = {40.3, 71.1, -38.9, 119};
    s.front.shoulder_spread_deg = {0, 0, 15.5, 0};
    s.front.hip_yaw_pitch_deg = {-89, 0, -87.9, -23.8};
    s.front.hip_roll_deg = {13.1, 17.4, -24, 5};
    s.front.hip_pitch_deg = {-21.2, 77.2, 99, 99};
    s.front.knee_deg = {0, -72.7, -128.4, -128.9};
    s.front.ankle_deg = {40.4, -41.3, -42.8, 32.8};
    s.front.stand_s = 0.2;
    return s;
}

Sequences type_2() {
    Sequences s;
    s.back.duration_s = {0.22, 0.12, 0.26, 0.06};
    s.back.shoulder_pitch_deg = {96.3, 119, 34.2, -24.8};
    s.back.shoulder_spread_deg = {20.1, 75.1, 54.8, 21};
    s.back.hip_yaw_pitch_deg = {-39, -74.6, -89, 0};
    s.back.hip_roll_deg = {26.5, -24, -18.3, 28.1};
    s.back.hip_pitch_deg = {93.9, 60.2, 97.8, -9.2};
    s.back.knee_deg = {0, -100.1, -116, -121};
    s.back.ankle_deg = {74, -9.7, -21.9, 67.7};
    s.back.stand_s = 0.26;
    s.front.duration_s = {0.34, 0.06, 0.32, 0.16};
    s.front.shoulder_pitch_deg = {62.8, 15.8, -44.3, 0.2};
    s.front.shoulder_spread_deg = {8.3, 0, 13.1, 9.4};
    s.front.hip_yaw_pitch_deg = {-9.3, -89, -89, -22.9};
    s.front.hip_roll_deg = {0.5, 42, 34.7, 23.5};
    s.front.hip_pitch_deg = {-4.5, 88.6, 99, 99};
    s.front.knee_deg = {-48.7, -76.7, -90.5, -114.4};
    s.front.ankle_deg = {74, 36.5, -26.9, 30.3};
    s.front.stand_s = 0.3;
    return s;
}

Sequences type_3() {
    Sequences s;
    s.back.duration_s = {0.16, 0.08, 0.42, 0.08};
    s.back.shoulder_pitch_deg = {65.3, 119, 36.1, -84.5};
    s.back.shoulder_spread_deg = {18.7, 30, 67.7, 0};
    s.back.hip_yaw_pitch_deg = {0, -79.2, -89, 0};
    s.back.hip_roll_deg = {10.8, -24, -24, 44};
    s.back.hip_pitch_deg = {96.8, 99, 99, -21};
    s.back.knee_deg = {-5.2, -71.8, -129, -83.4};
    s.back.ankle_deg = {32.3, -44, -10.3, 40.9};
    s.back.stand_s = 0.22;
    s.front.duration_s = {0.54, 0.26, 0.3, 0.38};
    s.front.shoulder_pitch_deg = {67.6, 81.2, -21.9, 119};
    s.front.shoulder_spread_deg = {3.3, 0, 27.9, 0};
    s.front.hip_yaw_pitch_deg = {-76.4, 0, -89, -18.4};
    s.front.hip_roll_deg = {31.1, 28.8, -24, 9.2};
    s.front.hip_pitch_deg = {-8.5, 79.4, 97.6, 97.7};
    s.front.knee_deg = {0, -48.1, -120.7, -129};
    s.front.ankle_deg = {29.1, -44, -44, 43.1};
    s.front.stand_s = 0.26;
    return s;
}

Sequences type_4() {
    Sequences s;
    s.back.duration_s = {0.2, 0.08, 0.24, 0.08};
    s.back.shoulder_pitch_deg = {100, 45.1, 72.7, -10.4};
    s.back.shoulder_spread_deg = {27.2, 67.6, 94, 21.6};
    s.back.hip_yaw_pitch_deg = {-40.4, -49.5, -79.3, -25.5};
    s.back.hip_roll_deg = {13.3, 4.2, -23.1, 35.9};
    s.back.hip_pitch_deg = {88.2, 69, 98.3, -2.9};
    s.back.knee_deg = {0, -64.1, -83.4, -128.2};
    s.back.ankle_deg = {62.4, -12.2, -28.2, 35.7};
    s.back.stand_s = 0.1;
    s.front.duration_s = {0.28, 0.18, 0.22, 0.12};
    s.front.shoulder_pitch_deg = {65.5, 30.7, -58.7, -32.2};
    s.front.shoulder_spread_deg = {9.5, 26.5, 9, 2.2};
    s.front.hip_yaw_pitch_deg = {-39.6, -89, -89, -14.4};
    s.front.hip_roll_deg = {16.2, 44, 22.8, -8.3};
    s.front.hip_pitch_deg = {-21.8, 74.2, 98.1, 99};
    s.front.knee_deg = {-64.8, -95.5, -115.4, -126.8};
    s.front.ankle_deg = {50.2, 15.9, -10.3, 42.1};
    s.front.stand_s = 0.18;
    return s;
}

}  // namespace

Config::Config() : type{type_0(), type_1(), type_2(), type_3(), type_4()} {}

}  // namespace k3d::agent::getup
