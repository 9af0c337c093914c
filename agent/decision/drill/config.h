// SPDX-License-Identifier: BSD-3-Clause
// Settings of a drill: what a robot practises alone, told by its configuration.
#pragma once

#include <string>

#include "common/config/fields.h"

namespace k3d::agent::decision {

/// Positions in the absolute field frame, which for the left team is the team frame.
struct DrillConfig {
    std::string task = "stand";
    double forward = 0.0;
    double left = 0.0;
    double turn = 0.0;
    double centre_x = -7.0;
    double centre_y = 0.0;
    double half_area = 4.0;
    double shortest = 2.0;
    double longest = 8.0;
    double target_x = 0.0;
    double target_y = 0.0;
    std::string fall = "front";
    double fall_every = 0.0;

    void describe(config::Fields& f) {
        f.text("task", task, {"stand", "walk", "go_to", "kick", "possess", "get_up"},
               "walk: with a fixed velocity; go_to: to random poses; kick: once, at the target; "
               "possess: stand ready to kick; get_up: after a fall of its own making");
        f.number("forward", forward, {-2.0, 2.0}, "m/s", "walk: velocity");
        f.number("left", left, {-2.0, 2.0}, "m/s", "walk: velocity to the left");
        f.number("turn", turn, {-4.0, 4.0}, "rad/s", "walk: turn to the left");
        f.number("centre_x", centre_x, {-15.0, 15.0}, "m", "go_to: middle of the area");
        f.number("centre_y", centre_y, {-10.0, 10.0}, "m", "go_to: middle of the area");
        f.number("half_area", half_area, {0.5, 10.0}, "m", "go_to: half the area's side");
        f.number("shortest", shortest, {0.5, 60.0}, "s", "go_to: shortest time with one target");
        f.number("longest", longest, {0.5, 60.0}, "s", "go_to: longest time with one target");
        f.number("target_x", target_x, {-30.0, 30.0}, "m", "kick, possess: where the ball shall go");
        f.number("target_y", target_y, {-30.0, 30.0}, "m", "kick, possess: where the ball shall go");
        f.text("fall", fall, {"front", "back", "left", "right"}, "get_up: which way to fall");
        f.number("fall_every", fall_every, {0.0, 250.0}, "s",
                 "go_to: time from one fall on purpose to the next, to the front, back, left and right "
                 "in turn; 0 = none");
    }
};

}  // namespace k3d::agent::decision
