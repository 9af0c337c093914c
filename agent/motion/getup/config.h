// SPDX-License-Identifier: BSD-3-Clause
// Parameters of getting up: two keyframe sequences for each type of robot, the roll from the side, times.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "common/config/fields.h"
#include "common/nao/model.h"

namespace k3d::agent::getup {

/// Keyframes, played one after another with linear interpolation; entry k of every list is frame k.
/// Both sides of the body do the same, so angles are given once: spread and roll count outwards,
/// the others have the sign of the robot's table. The soles stay parallel to the pelvis in roll.
struct Sequence {
    std::vector<double> duration_s;
    std::vector<double> shoulder_pitch_deg;
    std::vector<double> shoulder_spread_deg;
    std::vector<double> hip_yaw_pitch_deg;
    std::vector<double> hip_roll_deg;
    std::vector<double> hip_pitch_deg;
    std::vector<double> knee_deg;
    std::vector<double> ankle_deg;
    double stand_s = 0.4;  ///< from the last keyframe to the stand

    void describe(config::Fields& f) {
        f.numbers("duration_s", duration_s, {0.02, 2.0}, "s", "time to reach each keyframe");
        f.numbers("shoulder_pitch_deg", shoulder_pitch_deg, {-119, 119}, "deg",
                  "arms: 0 forward, -90 down along the body");
        f.numbers("shoulder_spread_deg", shoulder_spread_deg, {0, 94}, "deg", "arms outward");
        f.numbers("hip_yaw_pitch_deg", hip_yaw_pitch_deg, {-89, 0}, "deg",
                  "negative: legs forward and turned outward");
        f.numbers("hip_roll_deg", hip_roll_deg, {-24, 44}, "deg", "legs outward");
        f.numbers("hip_pitch_deg", hip_pitch_deg, {-24, 99}, "deg", "positive: thigh forward");
        f.numbers("knee_deg", knee_deg, {-129, 0}, "deg", "negative: knee bent");
        f.numbers("ankle_deg", ankle_deg, {-44, 74}, "deg", "positive: toes up");
        f.number("stand_s", stand_s, {0.02, 2.0}, "s", "last keyframe to the stand");
    }
};

/// From either side.
struct Sequences {
    Sequence back;
    Sequence front;

    void describe(config::Fields& f) {
        f.section("back", back);
        f.section("front", front);
    }
};

struct Config {
    std::array<Sequences, nao::kTypeCount> type;  ///< by type of robot
    double tuck_s = 0.3;
    double rest_rate = 0.8;
    double rest_limit_s = 0.8;
    double roll_s = 0.3;
    double roll_hold_s = 0.2;
    double roll_pitch_deg = -30.0;
    double roll_spread_deg = 70.0;
    double settle_s = 0.2;
    double settle_rate = 0.5;
    double retry_slower = 1.15;

    Config();  ///< the tuned values

    void describe(config::Fields& f) {
        f.number("tuck_s", tuck_s, {0.02, 2.0}, "s", "from the pose of the fall to straight limbs");
        f.number("rest_rate", rest_rate, {0.01, 20.0}, "rad/s",
                 "turning slower than this counts as lying still");
        f.number("rest_limit_s", rest_limit_s, {0.0, 5.0}, "s", "longest wait for lying still");
        f.number("roll_s", roll_s, {0.02, 2.0}, "s", "from the side: time to push the lower arm out");
        f.number("roll_hold_s", roll_hold_s, {0.0, 2.0}, "s", "from the side: time to fall over");
        f.number("roll_pitch_deg", roll_pitch_deg, {-119, 119}, "deg",
                 "from the side: shoulder pitch of the lower arm");
        f.number("roll_spread_deg", roll_spread_deg, {0, 94}, "deg",
                 "from the side: spread of the lower arm");
        f.number("settle_s", settle_s, {0.0, 2.0}, "s", "standing quietly this long ends the motion");
        f.number("settle_rate", settle_rate, {0.01, 20.0}, "rad/s",
                 "turning slower than this counts as standing quietly");
        f.number("retry_slower", retry_slower, {0.5, 2.0}, "",
                 "each further try plays its keyframes slower by this factor");
        constexpr std::array<std::string_view, nao::kTypeCount> kSections{"type_0", "type_1", "type_2",
                                                                          "type_3", "type_4"};
        for (std::size_t n = 0; n < type.size(); ++n) f.section(kSections[n], type[n]);
    }
};

}  // namespace k3d::agent::getup
