// SPDX-License-Identifier: BSD-3-Clause
// The tuned kicks by type; what they reached is noted in agent/config/kick_by_type.toml.
#include "agent/motion/kick_by_type.h"

namespace k3d::agent::motion {

namespace {

TypeKick type_1_kick() {
    TypeKick k;
    k.ball_forward = 0.181;
    k.ball_outward = 0.025;
    k.swing.reach_m = 5.5;
    k.swing.duration_s = {0.22, 0.02, 0.02, 0.02, 0.18};
    k.swing.kicking.hip_yaw_pitch_deg = {-5.9, -36.3, -0.7, -6.6, 0};
    k.swing.kicking.hip_roll_deg = {-19, -27.5, -3.1, 7.2, 6.3};
    k.swing.kicking.hip_pitch_deg = {43.7, -13.3, 24.3, 98.7, 52.8};
    k.swing.kicking.knee_deg = {-93.1, -36.3, -18.3, -64.8, -24.7};
    k.swing.kicking.ankle_pitch_deg = {25.7, 46.2, 74, 3.5, -13.2};
    k.swing.kicking.ankle_roll_deg = {-7.3, -0.4, 1, -6.7, 0.6};
    k.swing.support.hip_yaw_pitch_deg = {-37.5, -17.5, -13.9, -3.7, -1};
    k.swing.support.hip_roll_deg = {-29.2, -2.5, -21.9, 1.8, 25.5};
    k.swing.support.hip_pitch_deg = {20.2, 38.4, 50.6, -24, 53.4};
    k.swing.support.knee_deg = {-35.7, -20.1, -50.8, -25.1, -57.2};
    k.swing.support.ankle_pitch_deg = {27.6, 68.1, 29.5, 23.1, 49.4};
    k.swing.support.ankle_roll_deg = {18.1, 37.7, 30.9, 6.6, -13.6};
    k.swing.stand_s = 0.34;
    return k;
}

TypeKick type_3_kick() {
    TypeKick k;
    k.ball_forward = 0.181;
    k.ball_outward = 0.038;
    k.swing.reach_m = 5.3;
    k.swing.duration_s = {0.2, 0.02, 0.02, 0.02, 0.18};
    k.swing.kicking.hip_yaw_pitch_deg = {0, -25.1, -0.7, 0, -2.1};
    k.swing.kicking.hip_roll_deg = {-16.2, -44, -6.2, 19.3, -4.2};
    k.swing.kicking.hip_pitch_deg = {64.3, 7.1, 9, 91.4, 37.6};
    k.swing.kicking.knee_deg = {-88.1, -4.3, -24.5, -62.7, -19.7};
    k.swing.kicking.ankle_pitch_deg = {24.4, 69.8, 59.4, -10.8, -1.3};
    k.swing.kicking.ankle_roll_deg = {-11.6, 7.6, -12.6, -4.2, -1.4};
    k.swing.support.hip_yaw_pitch_deg = {-41.8, -1.7, -12, -5.7, 0};
    k.swing.support.hip_roll_deg = {-24.3, 1, -3.9, 1.9, 32.6};
    k.swing.support.hip_pitch_deg = {6.8, 35.8, 59.7, -21.4, 65};
    k.swing.support.knee_deg = {-37, -26.5, -60.1, -22.2, -56.3};
    k.swing.support.ankle_pitch_deg = {27.1, 45.4, 46.3, 19.8, 48.3};
    k.swing.support.ankle_roll_deg = {18, 41.2, 13.1, 12.6, 0.1};
    k.swing.stand_s = 0.18;
    return k;
}

}  // namespace

KickByType::KickByType() : type_1(type_1_kick()), type_3(type_3_kick()) {}

kick::Config kick_of_type(kick::Config kick, const KickByType& by_type, int type) {
    // The longest swing and those to the side are type 0's alone.
    if (type != 0) kick.farthest.on = kick.slant.on = kick.square.on = false;
    if (type != 1 && type != 3) return kick;
    const TypeKick& own = type == 1 ? by_type.type_1 : by_type.type_3;
    kick.straight.ball_forward = own.ball_forward;
    kick.straight.ball_outward = own.ball_outward;
    kick.near = kick.far = own.swing;
    return kick;
}

}  // namespace k3d::agent::motion
