// SPDX-License-Identifier: BSD-3-Clause
#include "agent/motion/walk/config.h"

namespace k3d::agent::motion::walk {

void Config::describe(config::Fields& f) {
    f.number("max_forward", max_forward, {0.0, 1.5}, "m/s", "top speed forward");
    f.number("max_backward", max_backward, {0.0, 1.5}, "m/s", "top speed backward");
    f.number("max_sideways", max_sideways, {0.0, 1.5}, "m/s", "top speed sideways");
    f.number("max_turn", max_turn, {0.0, 4.0}, "rad/s", "top turning speed");
    f.number("forward_acceleration", forward_acceleration, {0.05, 20.0}, "m/s^2",
             "how fast the forward speed may grow");
    f.number("sideways_acceleration", sideways_acceleration, {0.05, 20.0}, "m/s^2",
             "how fast the sideways speed may change");
    f.number("turn_acceleration", turn_acceleration, {0.1, 100.0}, "rad/s^2",
             "how fast the turning speed may change");
    f.number("braking", braking, {0.05, 20.0}, "m/s^2", "how fast the forward speed may fall to 0");

    f.number("combined", combined, {0.5, 4.0}, "",
             "exponent p: the shares of the three top speeds keep (a^p + b^p + c^p) <= 1");
    f.number("brisk_combined", brisk_combined, {0.5, 4.0}, "",
             "combined of a walk that is asked to be brisk");
    f.numbers("type_speed", type_speed, {0.1, 2.0}, "",
              "by robot type: top speeds and accelerations over those of type 0");
    f.numbers("type_step_duration", type_step_duration, {0.5, 2.0}, "",
              "by robot type: step_duration over that of type 0");
    f.number("forward_scale", forward_scale, {0.5, 2.0}, "",
             "speed of the steps over the speed wanted, since feet slip");
    f.number("forward_slip", forward_slip, {0.0, 0.3}, "m/s",
             "forward speed that slipping costs, added to the steps below top speed");
    f.number("sideways_scale", sideways_scale, {0.5, 2.0}, "", "the same sideways");
    f.number("turn_scale", turn_scale, {0.5, 2.0}, "", "the same for turning");
    f.number("heading_gain", heading_gain, {0.0, 20.0}, "1/s",
             "extra turn per heading error that the gyro has seen");

    f.number("step_duration", step_duration, {0.08, 0.6}, "s", "time from one landing to the next");
    f.number("lift_start", lift_start, {0.0, 0.45}, "", "share of the step before the foot lifts");
    f.number("lift_end", lift_end, {0.55, 1.0}, "", "share of the step after which it has landed");
    f.number("step_height", step_height, {0.0, 0.12}, "m", "how high the foot lifts on the spot");
    f.number("step_height_gain", step_height_gain, {-0.05, 0.1}, "s",
             "extra lift per forward speed");
    f.number("lift_shape", lift_shape, {0.2, 3.0}, "",
             "exponent of the half sine of the lift: small lifts early and lands late");
    f.number("landing_match", landing_match, {0.0, 1.5}, "",
             "share of the ground's speed that the foot takes on at lift and landing");

    f.number("swing_ease", swing_ease, {0.0, 1.5}, "",
             "0 swings the foot at constant speed, 1 starts and ends its way at rest");

    f.number("crouch", crouch, {0.005, 0.12}, "m",
             "how much lower the hips are than on straight legs");
    f.number("spread", spread, {-0.02, 0.05}, "m", "how much wider than the hips a foot stands");
    f.number("foot_forward", foot_forward, {-0.06, 0.06}, "m", "feet ahead of the hips");
    f.number("foot_forward_gain", foot_forward_gain, {-0.1, 0.1}, "s",
             "feet ahead of the hips per forward speed");
    f.number("lean", lean, {-0.5, 0.5}, "rad", "torso pitch on the spot, positive forward");
    f.number("lean_gain", lean_gain, {-0.5, 0.8}, "rad s/m", "torso pitch per forward speed");
    f.number("sway", sway, {-0.05, 0.05}, "m", "how far the hips swing over the support foot");
    f.number("sway_phase", sway_phase, {-3.2, 3.2}, "rad", "lead of the sway before the step");
    f.number("toe_up", toe_up, {-0.5, 0.5}, "rad", "pitch of the foot in the air, positive down");

    f.number("pitch_lead", pitch_lead, {0.0, 0.3}, "s", "how far ahead pitch is predicted");
    f.number("roll_lead", roll_lead, {0.0, 0.3}, "s", "how far ahead roll is predicted");
    f.number("support_pitch", support_pitch, {-1.5, 1.5}, "",
             "share of the pitch error by which the support leg swings at the hip");
    f.number("support_roll", support_roll, {-1.5, 1.5}, "", "the same for roll");
    f.number("support_turn_pitch", support_turn_pitch, {-1.5, 1.5}, "",
             "share of the pitch error by which the support foot turns at the ankle");
    f.number("support_turn_roll", support_turn_roll, {-1.5, 1.5}, "", "the same for roll");
    f.number("swing_pitch", swing_pitch, {-1.5, 1.5}, "",
             "share of the pitch error by which the swing leg swings at the hip");
    f.number("swing_roll", swing_roll, {-1.5, 1.5}, "", "the same for roll");
    f.number("swing_turn_pitch", swing_turn_pitch, {-1.5, 1.5}, "",
             "share of the pitch error by which the swing foot turns at the ankle");
    f.number("swing_turn_roll", swing_turn_roll, {-1.5, 1.5}, "", "the same for roll");
    f.number("step_forward", step_forward, {-1.0, 1.0}, "m/rad",
             "how far ahead the next landing moves per pitch error");
    f.number("step_forward_rate", step_forward_rate, {-0.2, 0.2}, "m s/rad", "per pitch rate");
    f.number("step_sideways", step_sideways, {-1.0, 1.0}, "m/rad",
             "how far aside the next landing moves per roll error");
    f.number("step_sideways_rate", step_sideways_rate, {-0.2, 0.2}, "m s/rad", "per roll rate");

    f.number("shoulder_pitch", shoulder_pitch, {-2.0, 0.5}, "rad", "arms: -pi/2 hangs down");
    f.number("shoulder_yaw", shoulder_yaw, {0.0, 1.5}, "rad", "arms away from the body");
    f.number("arm_roll", arm_roll, {-2.0, 2.0}, "rad", "turn of the upper arm that aims the elbow");
    f.number("elbow", elbow, {0.0, 1.5}, "rad", "bend of the elbows");
    f.number("arm_swing", arm_swing, {-8.0, 8.0}, "rad/m", "arm swing against the own side's foot");
}

}  // namespace k3d::agent::motion::walk
