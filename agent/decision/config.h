// SPDX-License-Identifier: BSD-3-Clause
// Settings of the decisions: the game's measures, keepers, their target choice, takers.
#pragma once

#include <string>

#include "common/config/fields.h"

namespace k3d::agent::decision {

/// The keepaway game as the agent is told about it (paper 2).
struct KeepawayConfig {
    double side = 10.0;
    int keepers = 3;

    void describe(config::Fields& f) {
        f.number("side", side, {4.0, 20.0}, "m", "side of the square area about the field's centre");
        f.integer("keepers", keepers, {1, 11}, "", "keepers in the game");
    }
};

/// Roles and the K1 keeper's conduct (paper 5.1).
struct KeeperConfig {
    std::string policy = "handcoded";
    std::string open;
    double hold_threshold = 1.6;
    double role_hysteresis = 0.4;
    double tie_margin = 0.5;
    double claim_memory = 0.6;
    double order_memory = 2.0;
    double fallen_penalty = 2.0;
    double target_margin = 0.03;
    double commit_margin = 0.1;
    double area_margin = 0.4;
    double stance_margin = 0.12;
    double landing_margin = 0.4;
    double landing_error = 0.8;
    double lane_margin = 0.4;
    double lane_far = 5.0;
    double lane_near = 1.5;
    double pressure_far = 2.0;
    double pressure_near = 0.7;
    double evade_distance = 0.5;
    double taker_speed = 0.75;
    double taker_reach = 0.35;
    double kick_time_s = 1.2;
    double patience_s = 0.3;
    double change_s = 0.4;
    double longest_kick = 6.0;

    void describe(config::Fields& f) {
        f.text("policy", policy, {},
               "how K1 values targets: handcoded, still, hold, random, or a network file");
        f.text("open", open, {},
               "network file that values K3's places; empty: keeper.policy's, or K3 goes home as in the paper");
        f.number("hold_threshold", hold_threshold, {0.0, 20.0}, "m",
                 "K1 holds while the nearest taker is farther from the ball than this");
        f.number("role_hysteresis", role_hysteresis, {0.0, 5.0}, "m",
                 "head start of the present K1 when distances to the ball's finish are compared");
        f.number("tie_margin", tie_margin, {0.0, 5.0}, "m",
                 "within this difference the word of a team-mate who says that it is K1 counts");
        f.number("claim_memory", claim_memory, {0.05, 10.0}, "s", "how long such a word counts");
        f.number("order_memory", order_memory, {0.05, 10.0}, "s",
                 "how long target and role that K1 said are followed");
        f.number("fallen_penalty", fallen_penalty, {0.0, 10.0}, "m",
                 "distance that lying on the ground counts for");
        f.number("target_margin", target_margin, {0.0, 1.0}, "",
                 "keep the target while no more than this share of the others is better");
        f.number("commit_margin", commit_margin, {0.0, 1.0}, "",
                 "the same once a taker is within hold_threshold: no time to change one's mind");
        f.number("area_margin", area_margin, {0.0, 2.0}, "m",
                 "K2 and K3 walk only to places this far inside the boundary");
        f.number("stance_margin", stance_margin, {0.0, 2.0}, "m",
                 "no targets for which K1 would have to stand nearer to the boundary than this");
        f.number("landing_margin", landing_margin, {-5.0, 5.0}, "m",
                 "no targets for which the kick would send the ball nearer to the boundary");
        f.number("landing_error", landing_error, {0.0, 20.0}, "m",
                 "nor those that the kick would miss by more, short or far");
        f.number("lane_margin", lane_margin, {-20.0, 20.0}, "m",
                 "nor those towards which the ball would pass a taker near by at less than this");
        f.number("lane_far", lane_far, {0.0, 20.0}, "m", "near by: not farther from the ball");
        f.number("lane_near", lane_near, {0.0, 20.0}, "m",
                 "how near to the ball it is supposed to have come when it is kicked");
        f.number("pressure_far", pressure_far, {0.0, 20.0}, "m",
                 "a taker this near to the ball begins to loosen the kick's tolerances");
        f.number("pressure_near", pressure_near, {0.0, 20.0}, "m",
                 "a taker this near loosens them fully");
        f.number("evade_distance", evade_distance, {0.0, 5.0}, "m",
                 "K3 steps aside from a taker this near");
        f.number("taker_speed", taker_speed, {0.05, 5.0}, "m/s",
                 "K1 takes targets that it can kick at before a taker as fast as this has come");
        f.number("taker_reach", taker_reach, {0.0, 2.0}, "m", "has come: is this near to the ball");
        f.number("kick_time_s", kick_time_s, {0.0, 5.0}, "s",
                 "from standing in the stance until the ball has gone");
        f.number("patience_s", patience_s, {0.0, 20.0}, "s",
                 "if no target is in time, those are taken that are later than the soonest by less");
        f.number("change_s", change_s, {0.0, 20.0}, "s",
                 "K1's present target counts as this much sooner");
        f.number("longest_kick", longest_kick, {0.0, 30.0}, "m",
                 "K1 asks for no more: beyond it the stance must be exact, which takes time");
    }
};

/// Target points and the hand-coded evaluation (paper 5.3, Algorithm 2).
struct EvaluationConfig {
    double cell = 1.0;
    double margin = 0.1;
    double min_pass = 0.5;
    double ideal_pass_m = 6.0;
    double towards_deg = 30.0;
    double away_deg = 105.0;
    double moved = 0.5;
    double far_receiver = 6.0;
    double bad_length = 4.0;
    double narrow_deg = 20.0;
    double floor_deg = 1.0;
    double penalty = 10.0;
    double away_divisor = 2.0;

    void describe(config::Fields& f) {
        f.number("cell", cell, {0.1, 5.0}, "m", "distance of neighbouring target points");
        f.number("margin", margin, {0.0, 0.4}, "", "margin without target points, share of the side");
        f.number("min_pass", min_pass, {0.0, 5.0}, "m", "points nearer to the ball are no targets");
        f.number("ideal_pass_m", ideal_pass_m, {0.5, 20.0}, "m", "length of pass that f3 likes best");
        f.number("towards_deg", towards_deg, {0.0, 180.0}, "deg",
                 "f5, f6 below this: the taker comes towards the point");
        f.number("away_deg", away_deg, {0.0, 180.0}, "deg",
                 "f5, f6 above this: the taker goes away from the point");
        f.number("moved", moved, {0.0, 5.0}, "m", "f7, f8 above this: the taker moves");
        f.number("far_receiver", far_receiver, {0.0, 100.0}, "m^2", "f4 above this is bad");
        f.number("bad_length", bad_length, {1.0, 100.0}, "m^2", "f3 above this is bad");
        f.number("narrow_deg", narrow_deg, {0.0, 180.0}, "deg", "f1 below this is bad");
        f.number("floor_deg", floor_deg, {0.01, 90.0}, "deg", "f1 counts as at least this in f2*f3/f1");
        f.number("penalty", penalty, {0.0, 1000.0}, "", "added to the value of bad points");
        f.number("away_divisor", away_divisor, {1.0, 100.0}, "",
                 "divides the value of points that takers go away from");
    }
};

/// Takers (paper 5.2).
struct TakerConfig {
    std::string strategy = "greedy";
    double top_speed = 2.0;
    double chaser_hysteresis = 0.3;
    double follow_distance = 0.6;
    double pass_distance = 0.7;
    double pass_margin = 0.4;
    double pass_delay = 0.2;

    void describe(config::Fields& f) {
        f.text("strategy", strategy, {"greedy", "greedy_random"},
               "greedy: all chase the ball; greedy_random: one does, the others follow keepers");
        f.number("top_speed", top_speed, {0.05, 2.0}, "m/s",
                 "takers ask for no faster walk forward, whatever skills.forward_speed allows");
        f.number("chaser_hysteresis", chaser_hysteresis, {0.0, 5.0}, "m",
                 "head start of the present chaser when distances to the ball are compared");
        f.number("follow_distance", follow_distance, {0.3, 5.0}, "m",
                 "how near a follower comes to its keeper");
        f.number("pass_distance", pass_distance, {0.0, 10.0}, "m",
                 "a pass moves the ball's finish at least this far");
        f.number("pass_margin", pass_margin, {0.0, 5.0}, "m",
                 "and makes another keeper nearest to it by this much");
        f.number("pass_delay", pass_delay, {0.0, 5.0}, "s", "for at least this long");
    }
};

/// Getting possession of the ball (paper 4).
struct PossessionConfig {
    std::string chooser = "rules";
    std::string network;
    double at_rest = 0.5;
    double position_distance = 1.5;
    double wait_distance = 0.4;
    double passing_by_deg = 60.0;

    void describe(config::Fields& f) {
        f.text("chooser", chooser, {"rules", "straight", "random"},
               "who chooses without a network: the rules below, or as baselines straight to where the "
               "ball is, or a state at random");
        f.text("network", network, {}, "file of the network that chooses; empty: the chooser");
        f.number("at_rest", at_rest, {0.0, 5.0}, "m", "a ball this near to its finish has arrived");
        f.number("position_distance", position_distance, {0.2, 5.0}, "m",
                 "this near to the finish position for the kick");
        f.number("wait_distance", wait_distance, {0.0, 5.0}, "m",
                 "stand still for a ball that comes this near");
        f.number("passing_by_deg", passing_by_deg, {0.0, 180.0}, "deg",
                 "ball and finish seen this far apart: it passes by, intercept it");
    }
};

}  // namespace k3d::agent::decision
