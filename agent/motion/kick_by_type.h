// SPDX-License-Identifier: BSD-3-Clause
// The kick of robot types whose legs need another swing than type 0's: one swing, and where the ball
// must lie for it. Metres, degrees.
#pragma once

#include "agent/motion/kick/config.h"
#include "common/config/fields.h"

namespace k3d::agent::motion {

/// A swing for one distance.
struct TypeKick {
    double ball_forward = 0.17;
    double ball_outward = 0.03;
    kick::Swing swing;

    void describe(config::Fields& f) {
        f.number("ball_forward", ball_forward, {0.0, 0.5}, "m",
                 "where the ball lies for the right foot's kick, ahead of the torso");
        f.number("ball_outward", ball_outward, {-0.2, 0.3}, "m",
                 "the same, to the kicking foot's side");
        swing.describe(f);
    }
};

struct KickByType {
    TypeKick type_1;
    TypeKick type_3;

    KickByType();  ///< the tuned values

    void describe(config::Fields& f) {
        f.section("type_1", type_1);
        f.section("type_3", type_3);
    }
};

/// `kick` as a robot of `type` (0 to 4) kicks: types 0, 2 and 4 take it as it is,
/// but only type 0 has the longest kick and those aside.
kick::Config kick_of_type(kick::Config kick, const KickByType& by_type, int type);

}  // namespace k3d::agent::motion
