// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the world model; file agent/config/world.toml.
#pragma once

#include "common/config/fields.h"

namespace k3d::agent::world {

struct BallConfig {
    // A ball rolling with v stops after v / 1.06 (field::kRollDecay). The paper takes v from two
    // positions 0.06 s apart, hence the speed half an interval ago: alpha = 0.06 / (e^0.0636 - 1).
    double alpha = 0.914;
    double lambda = 0.5;
    double memory = 6.0;
    double hear_after = 0.5;
    double acceleration_sd = 0.15;
    double rest_acceleration_sd = 0.05;
    double kick_gate = 25.0;
    double kick_speed_sd = 5.0;
    double max_speed = 12.0;
    double moving_speed = 0.25;
    double rest_speed = 0.12;
    int misses = 5;

    void describe(config::Fields& f) {
        f.number("alpha", alpha, {0, 5}, "s", "stopping point = position + alpha * velocity (3.2)");
        f.number("lambda", lambda, {0.01, 10}, "s", "time constant of the stopping point's mean");
        f.number("memory", memory, {0, 60}, "s", "how long an unseen ball stays known");
        f.number("hear_after", hear_after, {0, 60}, "s",
                 "unseen for this long, the ball is taken from team-mates");
        f.number("acceleration_sd", acceleration_sd, {0.01, 50}, "m/s^1.5",
                 "disturbance of a rolling ball");
        f.number("rest_acceleration_sd", rest_acceleration_sd, {0.001, 50}, "m/s^1.5",
                 "disturbance of a ball at rest");
        f.number("kick_gate", kick_gate, {4, 200}, "",
                 "squared normalised surprise above which the ball was kicked or stopped");
        f.number("kick_speed_sd", kick_speed_sd, {0.5, 20}, "m/s", "spread of its speed then");
        f.number("max_speed", max_speed, {2, 50}, "m/s", "a faster jump is no motion: start anew");
        f.number("moving_speed", moving_speed, {0.01, 5}, "m/s", "faster: the ball moves");
        f.number("rest_speed", rest_speed, {0, 5}, "m/s", "slower: it has come to rest");
        f.integer("misses", misses, {1, 100}, "sees",
                  "sees in a row that should show the ball and do not, until it is forgotten");
    }
};

struct TakerConfig {
    double lambda = 1.5;

    void describe(config::Fields& f) {
        f.number("lambda", lambda, {0.01, 20}, "s", "time constant of the lagged mean (5.3)");
    }
};

struct PlayersConfig {
    double memory = 8.0;
    double hear_after = 0.5;
    double acceleration_sd = 0.4;

    void describe(config::Fields& f) {
        f.number("memory", memory, {0, 60}, "s", "how long an unseen player stays known");
        f.number("hear_after", hear_after, {0, 60}, "s",
                 "unseen for this long, a player is where team-mates say it is");
        f.number("acceleration_sd", acceleration_sd, {0.01, 50}, "m/s^1.5",
                 "disturbance of a player's velocity");
    }
};

struct WorldConfig {
    BallConfig ball;
    TakerConfig taker;
    PlayersConfig players;

    void describe(config::Fields& f) {
        f.section("ball", ball);
        f.section("taker", taker);
        f.section("players", players);
    }
};

}  // namespace k3d::agent::world
