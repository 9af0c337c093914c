// SPDX-License-Identifier: BSD-3-Clause
// Settings of the skills: how fast to walk where, how exactly to stand for a kick, how to look.
#pragma once

#include <string>

#include "common/config/fields.h"

namespace k3d::agent::skills {

struct SkillConfig {
    // Speeds asked of the walk; the walk engine has the last word.
    double forward_speed = 0.85;
    double backward_speed = 0.45;
    double side_speed = 0.33;
    double turn_rate = 2.2;
    double gain = 4.0;
    double turn_gain = 3.0;
    double brisk_distance = 1.0;
    double brisk_turn_rate = 2.6;
    double brisk_turn_gain = 4.5;
    double near_distance = 0.4;
    double arrive_distance = 0.12;
    double leave_distance = 0.3;
    double arrive_angle = 0.2;
    double leave_angle = 0.45;
    double robot_clearance = 0.5;
    double ball_clearance = 0.35;

    std::string intercept = "earliest";

    double circle_radius = 0.36;
    double approach_speed = 0.08;
    double kick_tolerance_x = 0.012;
    double kick_tolerance_y = 0.028;
    double kick_tolerance_yaw = 0.18;
    double leisure = 1.5;
    double meet_before_finish = 0.25;
    double kick_lead = 0.38;
    double kick_loosen = 1.4;
    double kick_loosen_yaw = 2.0;
    double strike_keep_s = 0.35;

    double look_sweep = 0.6;
    double look_sweep_busy = 0.2;
    double look_period = 2.4;
    double look_lost_after = 0.7;
    double look_turn_after = 3.0;

    void describe(config::Fields& f) {
        f.number("forward_speed", forward_speed, {0.05, 2.0}, "m/s", "fastest walk forward asked for");
        f.number("backward_speed", backward_speed, {0.05, 2.0}, "m/s", "fastest walk backward asked for");
        f.number("side_speed", side_speed, {0.05, 2.0}, "m/s", "fastest walk sideways asked for");
        f.number("turn_rate", turn_rate, {0.1, 4.0}, "rad/s", "fastest turn asked for");
        f.number("gain", gain, {0.1, 10.0}, "1/s", "speed per metre left to go");
        f.number("turn_gain", turn_gain, {0.1, 10.0}, "1/s", "turn rate per radian left to turn");
        f.number("brisk_distance", brisk_distance, {0.2, 50.0}, "m",
                 "farther than this from the place it walks and turns harder");
        f.number("brisk_turn_rate", brisk_turn_rate, {0.1, 4.0}, "rad/s", "fastest turn then");
        f.number("brisk_turn_gain", brisk_turn_gain, {0.1, 10.0}, "1/s",
                 "turn rate per radian left to turn then");
        f.number("near_distance", near_distance, {0.1, 3.0}, "m",
                 "below this walk in all directions with the final heading, above it turn and walk");
        f.number("arrive_distance", arrive_distance, {0.01, 1.0}, "m", "stop walking this close");
        f.number("leave_distance", leave_distance, {0.02, 2.0}, "m", "start again when this far off");
        f.number("arrive_angle", arrive_angle, {0.02, 1.0}, "rad", "stop turning this close");
        f.number("leave_angle", leave_angle, {0.05, 2.0}, "rad", "start again when this far off");
        f.number("robot_clearance", robot_clearance, {0.0, 2.0}, "m",
                 "distance from a robot's centre kept while walking by");
        f.number("ball_clearance", ball_clearance, {0.0, 2.0}, "m",
                 "distance from the ball kept by those who do not want it");
        f.text("intercept", intercept, {"foot", "earliest"},
               "foot: perpendicular foot on the ball's path (paper 4.1); earliest: first point "
               "reached before the ball");
        f.number("circle_radius", circle_radius, {0.2, 1.0}, "m", "path around the ball");
        f.number("approach_speed", approach_speed, {0.0, 1.0}, "m/s",
                 "slowest walk on the last centimetres to the stance");
        f.number("kick_tolerance_x", kick_tolerance_x, {0.001, 0.2}, "m",
                 "error of the stance along the kick, at leisure");
        f.number("kick_tolerance_y", kick_tolerance_y, {0.001, 0.2}, "m",
                 "error of the stance across the kick, at leisure");
        f.number("kick_tolerance_yaw", kick_tolerance_yaw, {0.01, 1.0}, "rad",
                 "error of the stance's heading, at leisure");
        f.number("kick_loosen", kick_loosen, {1.0, 5.0}, "",
                 "factor on the position tolerances with a taker at the ball");
        f.number("kick_loosen_yaw", kick_loosen_yaw, {1.0, 10.0}, "",
                 "factor on the heading tolerance with a taker at the ball");
        f.number("strike_keep_s", strike_keep_s, {0.0, 10.0}, "s",
                 "another foot or swing than the one prepared for must be ready sooner by this");
        f.number("leisure", leisure, {1.0, 10.0}, "",
                 "who stands ready without kicking moves again beyond this many tolerances");
        f.number("meet_before_finish", meet_before_finish, {0.0, 1.0}, "m",
                 "a rolling ball is kicked this far before it would come to rest");
        f.number("kick_lead", kick_lead, {0.0, 1.0}, "s", "from the kick's beginning to the hit");
        f.number("look_sweep", look_sweep, {0.0, 1.0}, "rad",
                 "how far the head swings to both sides of the ball");
        f.number("look_sweep_busy", look_sweep_busy, {0.0, 1.0}, "rad", "the same while at the ball");
        f.number("look_period", look_period, {0.5, 10.0}, "s", "one swing of the head, there and back");
        f.number("look_lost_after", look_lost_after, {0.1, 10.0}, "s",
                 "search the ball with the head when it was not seen for this long");
        f.number("look_turn_after", look_turn_after, {0.5, 30.0}, "s",
                 "search it with the body too when it was not seen for this long");
    }
};

}  // namespace k3d::agent::skills
