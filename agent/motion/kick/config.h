// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the kick: where the ball must lie, and the keyframes of swings of the right foot,
// which the left one mirrors: a far and a near one straight ahead, a longer one, and two to the outside.
#pragma once

#include <vector>

#include "common/config/fields.h"

namespace k3d::agent::kick {

/// Six leg angles per keyframe, right leg's sign convention of the robot's table for the kicking
/// leg, left leg's for the supporting one; degrees.
struct LegFrames {
    std::vector<double> hip_yaw_pitch_deg;
    std::vector<double> hip_roll_deg;
    std::vector<double> hip_pitch_deg;
    std::vector<double> knee_deg;
    std::vector<double> ankle_pitch_deg;
    std::vector<double> ankle_roll_deg;

    void describe(config::Fields& f) {
        f.numbers("hip_yaw_pitch_deg", hip_yaw_pitch_deg, {-89, 0}, "deg",
                  "negative: leg forward and turned outward");
        f.numbers("hip_roll_deg", hip_roll_deg, {-44, 44}, "deg", "positive: leg to the left");
        f.numbers("hip_pitch_deg", hip_pitch_deg, {-24, 99}, "deg", "positive: leg forward");
        f.numbers("knee_deg", knee_deg, {-129, 0}, "deg", "negative: knee bent");
        f.numbers("ankle_pitch_deg", ankle_pitch_deg, {-44, 74}, "deg", "positive: toes up");
        f.numbers("ankle_roll_deg", ankle_roll_deg, {-44, 44}, "deg",
                  "positive: right edge of the foot down");
    }
};

/// One way to swing: keyframes from the stand to the stand, and how far the ball then goes.
struct Swing {
    double reach_m = 5.0;
    std::vector<double> duration_s;  ///< entry k of every list is keyframe k
    LegFrames kicking;
    LegFrames support;
    double stand_s = 0.3;  ///< from the last keyframe to the stand

    void describe(config::Fields& f) {
        f.number("reach_m", reach_m, {0.0, 20.0}, "m",
                 "how far this swing sends the ball; types 1 and 3 have motion.kick_by_type's in "
                 "place of near and far");
        f.numbers("duration_s", duration_s, {0.02, 2.0}, "s", "time to reach each keyframe");
        f.number("stand_s", stand_s, {0.02, 2.0}, "s", "last keyframe to the stand");
        f.section("kicking", kicking);
        f.section("support", support);
    }
};

/// The ball's place in the robot's frame for a kick with the right foot (mirrored for the left),
/// how far off it may lie, and where the ball then goes.
struct Placement {
    double ball_forward = 0.17;
    double ball_outward = 0.028;
    double reach_forward = 0.03;
    double reach_sideways = 0.025;
    double reach_direction_deg = 12.0;
    double aim_outward_deg = 0.0;

    void describe(config::Fields& f) {
        f.number("ball_forward", ball_forward, {0.0, 0.5}, "m",
                 "where the ball lies for the right foot's kick, ahead of the torso");
        f.number("ball_outward", ball_outward, {-0.2, 0.3}, "m",
                 "the same, to the kicking foot's side");
        f.number("reach_forward", reach_forward, {0.001, 0.2}, "m",
                 "how far off the ball may lie, ahead or behind");
        f.number("reach_sideways", reach_sideways, {0.001, 0.2}, "m",
                 "how far off the ball may lie, to either side");
        f.number("reach_direction_deg", reach_direction_deg, {0.1, 90.0}, "deg",
                 "how far the kick's direction may be off the one wanted");
        f.number("aim_outward_deg", aim_outward_deg, {-135.0, 135.0}, "deg",
                 "the ball goes this much to the kicking foot's side of straight ahead");
    }
};

/// A straight swing for targets that the others do not reach. The ball must lie at another place for
/// it, and more exactly, which takes longer to prepare.
struct LongSwing {
    bool on = true;
    double from_m = 6.0;
    double stance_share = 1.0;
    Placement place;
    Swing swing;

    void describe(config::Fields& f) {
        f.boolean("on", on, "whether the robot kicks this way; only type 0 does");
        f.number("from_m", from_m, {0.0, 20.0}, "m", "used where more than this is wanted");
        f.number("stance_share", stance_share, {0.05, 2.0}, "",
                 "error of the stance along the kick, over the other kicks'");
        place.describe(f);
        swing.describe(f);
    }
};

/// A swing that sends the ball aside, so that the robot need not walk round it first. It knows one
/// distance.
struct AngledSwing {
    bool on = true;
    Placement place;
    Swing swing;

    void describe(config::Fields& f) {
        f.boolean("on", on, "whether the robot kicks this way; only type 0 does");
        place.describe(f);
        swing.describe(f);
    }
};

struct Config {
    Placement straight;
    double settle_rate = 0.8;
    double settle_limit_s = 0.4;

    Swing far;   ///< as far as it goes
    Swing near;  ///< for short passes
    LongSwing farthest;
    AngledSwing slant;   ///< half to the side
    AngledSwing square;  ///< to the side
    double angled_miss_m = 0.35;

    Config();  ///< the tuned values

    /// How the swing for `distance` is mixed: 0 is near, 1 is far.
    double far_share(double distance) const;
    /// How far the ball goes when `distance` is wanted and the kick goes straight ahead.
    double reach_for(double distance) const;

    void describe(config::Fields& f) {
        straight.describe(f);
        f.number("settle_rate", settle_rate, {0.01, 20.0}, "rad/s",
                 "turning slower than this after the swing counts as standing quietly");
        f.number("settle_limit_s", settle_limit_s, {0.02, 2.0}, "s",
                 "longest wait for standing quietly");
        f.section("far", far);
        f.section("near", near);
        f.section("farthest", farthest);
        f.number("angled_miss_m", angled_miss_m, {0.0, 20.0}, "m",
                 "slant and square are used where their reach is off the wanted distance by less");
        f.section("slant", slant);
        f.section("square", square);
    }
};

}  // namespace k3d::agent::kick
