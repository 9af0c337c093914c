// SPDX-License-Identifier: BSD-3-Clause
// The tuned kick; what it reached is noted in agent/config/kick.toml.
#include "agent/motion/kick/config.h"

#include <algorithm>
#include <cmath>

namespace k3d::agent::kick {

namespace {

LongSwing tuned_farthest() {
    LongSwing a;
    a.from_m = 6.0;
    a.stance_share = 0.67;
    a.place.ball_forward = 0.179;
    a.place.ball_outward = 0.033;
    a.place.reach_forward = 0.025;
    a.place.reach_sideways = 0.045;
    a.place.reach_direction_deg = 12;
    a.place.aim_outward_deg = 2;
    a.swing.reach_m = 6.8;
    a.swing.duration_s = {0.28, 0.02, 0.02, 0.02, 0.18};
    a.swing.kicking.hip_yaw_pitch_deg = {-2, -21.1, -2.2, 0, -3.5};
    a.swing.kicking.hip_roll_deg = {-14.5, -35.2, -13.6, 17.5, -2.2};
    a.swing.kicking.hip_pitch_deg = {52.5, -11.4, 10.6, 94.2, 49.1};
    a.swing.kicking.knee_deg = {-89, -10.3, -28.5, -53.3, -13.9};
    a.swing.kicking.ankle_pitch_deg = {25.4, 66.9, 69.3, -2.6, -16.3};
    a.swing.kicking.ankle_roll_deg = {-1.2, 7.7, -14.1, -5.7, 1.5};
    a.swing.support.hip_yaw_pitch_deg = {-32.1, -12.2, -5.9, -1.7, -0.7};
    a.swing.support.hip_roll_deg = {-21.2, 0.4, -26.3, -3.7, 19.8};
    a.swing.support.hip_pitch_deg = {4.1, 19.4, 50.3, -24, 44.5};
    a.swing.support.knee_deg = {-36.2, -35.2, -45.6, -36.9, -55};
    a.swing.support.ankle_pitch_deg = {29.3, 49.5, 35.8, 29.4, 54.7};
    a.swing.support.ankle_roll_deg = {18.8, 23, 18.5, 6.8, -4.2};
    a.swing.stand_s = 0.33;
    return a;
}

AngledSwing tuned_slant() {
    AngledSwing a;
    a.place.ball_forward = 0.156;
    a.place.ball_outward = 0.099;
    a.place.reach_forward = 0.03;
    a.place.reach_sideways = 0.03;
    a.place.reach_direction_deg = 16;
    a.place.aim_outward_deg = 47;
    a.swing.reach_m = 4.6;
    a.swing.duration_s = {0.24, 0.02, 0.02, 0.02, 0.06};
    a.swing.kicking.hip_yaw_pitch_deg = {-2.3, -42.7, -0.1, -9.1, -48.3};
    a.swing.kicking.hip_roll_deg = {0.1, -43.3, 10.2, 16.1, -39};
    a.swing.kicking.hip_pitch_deg = {65.2, -10.3, 83.7, 99, 61};
    a.swing.kicking.knee_deg = {-74.4, 0, -14.3, -3.4, -27.9};
    a.swing.kicking.ankle_pitch_deg = {3.7, 44.6, -29.2, -8.9, 49.1};
    a.swing.kicking.ankle_roll_deg = {-24, 15.1, -4.8, -6, -3.9};
    a.swing.support.hip_yaw_pitch_deg = {-26.7, -8.7, -32.8, -4.8, 0};
    a.swing.support.hip_roll_deg = {-23.1, 20.2, 3.5, 9.1, 23.9};
    a.swing.support.hip_pitch_deg = {-24, 36.6, -0.1, -22.4, 31.1};
    a.swing.support.knee_deg = {-27.4, -56.5, -25, -36.4, -63.3};
    a.swing.support.ankle_pitch_deg = {60.6, -44, 42.3, -9.8, 74};
    a.swing.support.ankle_roll_deg = {11.5, 18.5, 7.7, 8, 15.4};
    a.swing.stand_s = 0.1;
    return a;
}

AngledSwing tuned_square() {
    AngledSwing a;
    a.place.ball_forward = 0.152;
    a.place.ball_outward = 0.135;
    a.place.reach_forward = 0.025;
    a.place.reach_sideways = 0.035;
    a.place.reach_direction_deg = 16;
    a.place.aim_outward_deg = 77;
    a.swing.reach_m = 4.6;
    a.swing.duration_s = {0.2, 0.02, 0.02, 0.02, 0.02};
    a.swing.kicking.hip_yaw_pitch_deg = {-27.8, -67.9, 0, -36.1, -48.1};
    a.swing.kicking.hip_roll_deg = {24, -23.8, 24, 21.1, -30.9};
    a.swing.kicking.hip_pitch_deg = {45.1, -24, 66.5, 83.6, 78.5};
    a.swing.kicking.knee_deg = {-83.6, -67.8, -3.7, -37.3, -54.1};
    a.swing.kicking.ankle_pitch_deg = {16.8, 56.5, 8.1, -7.5, 73.6};
    a.swing.kicking.ankle_roll_deg = {-15.4, 9.6, -16.1, -23.8, 21.7};
    a.swing.support.hip_yaw_pitch_deg = {-24, 0, -56.1, -0.2, -6.7};
    a.swing.support.hip_roll_deg = {-23.1, 44, 27.2, 2.4, 5.7};
    a.swing.support.hip_pitch_deg = {-19, 80.4, -0.3, -1.8, 11.8};
    a.swing.support.knee_deg = {-71.9, -28.8, -35, -40.2, -68.8};
    a.swing.support.ankle_pitch_deg = {74, -16.4, 3.8, 29.7, 73.3};
    a.swing.support.ankle_roll_deg = {-39.8, 17.7, 7.7, 19.8, -8};
    a.swing.stand_s = 0.1;
    return a;
}

}  // namespace

Config::Config() {
    straight.ball_forward = 0.167;
    straight.ball_outward = 0.033;
    straight.aim_outward_deg = 0;
    straight.reach_forward = 0.025;
    straight.reach_sideways = 0.045;
    straight.reach_direction_deg = 12;

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

    farthest = tuned_farthest();
    slant = tuned_slant();
    square = tuned_square();
}

double Config::far_share(double distance) const {
    if (distance >= far.reach_m) return 1.0;
    if (distance <= near.reach_m) return 0.0;
    // Measured: the first steps from near to far bring the most.
    return 1.0 - std::sqrt((far.reach_m - distance) / (far.reach_m - near.reach_m));
}

double Config::reach_for(double distance) const {
    if (farthest.on && distance > farthest.from_m) return std::min(distance, farthest.swing.reach_m);
    return std::max(std::min(distance, far.reach_m), near.reach_m);
}

}  // namespace k3d::agent::kick
