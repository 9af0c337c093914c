// SPDX-License-Identifier: BSD-3-Clause
// Parameters of motion: those of its engines, and when a fall is a fall.
#pragma once

#include "agent/motion/walk/config.h"

namespace k3d::agent::motion {

struct Config {
    double fallen_tilt = 0.9;
    double stance_rate = 2.5;
    walk::Config walk;

    void describe(config::Fields& f) {
        f.number("fallen_tilt", fallen_tilt, {0.3, 1.5}, "rad",
                 "torso tilt from which a fall is certain");
        f.number("stance_rate", stance_rate, {0.2, 6.0}, "rad/s",
                 "joint speed with which the stance is taken up from any other pose");
        f.section("walk", walk);
    }
};

}  // namespace k3d::agent::motion
