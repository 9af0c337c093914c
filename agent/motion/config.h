// SPDX-License-Identifier: BSD-3-Clause
// Parameters of motion: those of its engines, and when a fall is a fall.
#pragma once

#include "agent/motion/getup/config.h"
#include "agent/motion/kick/config.h"
#include "agent/motion/kick_by_type.h"
#include "agent/motion/walk/config.h"

namespace k3d::agent::motion {

struct Config {
    double fallen_tilt = 0.9;
    double stance_rate = 2.5;
    double fall_s = 0.4;
    double kick_settle_s = 0.2;
    double kick_hurry_s = 0.1;
    double odometry_forward = 1.12;
    double odometry_sideways = 1.16;
    walk::Config walk;
    kick::Config kick;
    KickByType kick_by_type;
    getup::Config getup;

    void describe(config::Fields& f) {
        f.number("fallen_tilt", fallen_tilt, {0.3, 1.5}, "rad",
                 "torso tilt from which a fall is certain");
        f.number("stance_rate", stance_rate, {0.2, 6.0}, "rad/s",
                 "joint speed with which the stance is taken up from any other pose");
        f.number("fall_s", fall_s, {0.0, 3.0}, "s", "from there until getting up begins");
        f.number("kick_settle_s", kick_settle_s, {0.0, 2.0}, "s", "quiet standing before a kick");
        f.number("kick_hurry_s", kick_hurry_s, {0.0, 2.0}, "s", "the same before a hurried one");
        f.number("odometry_forward", odometry_forward, {0.5, 2.0}, "",
                 "true way over the way told by the legs, forward and backward");
        f.number("odometry_sideways", odometry_sideways, {0.5, 2.0}, "", "the same sideways");
        f.section("walk", walk);
        f.section("kick", kick);
        f.section("kick_by_type", kick_by_type);
        f.section("getup", getup);
    }
};

}  // namespace k3d::agent::motion
