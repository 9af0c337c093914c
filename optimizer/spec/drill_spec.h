// SPDX-License-Identifier: BSD-3-Clause
// What a drill run is: which skill is measured how often, how it is set up, and where it is played.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/config/fields.h"

namespace k3d::optimizer::spec {

inline const std::vector<std::string> kDrillNames{
    "walk", "backward", "sideways", "turn", "go_to", "kick", "kick_task", "getup", "localise",
    "intercept", "ball_rolls"};

/// How the single drills are set up; lengths in the field, times simulated.
struct DrillSetup {
    double walk_m = 10.0;
    double walk_limit_s = 30.0;
    double turn_s = 8.0;
    double go_to_s = 120.0;
    double go_to_half_area = 3.0;
    double go_to_shortest = 2.0;
    double go_to_longest = 8.0;
    double go_to_reached = 0.3;
    double localise_s = 60.0;
    double kidnap_every_s = 12.0;
    double fall_every_s = 0.0;
    double ball_distance = 1.0;
    double ball_bearing_deg = 30.0;
    double target_distance = 5.0;
    double target_turn_deg = 45.0;
    double kick_limit_s = 25.0;
    double roll_least = 1.0;
    double roll_most = 6.0;
    bool roll_kicked = true;

    void describe(config::Fields& f) {
        f.number("walk_m", walk_m, {1.0, 14.0}, "m", "walk, backward, sideways: how far");
        f.number("walk_limit_s", walk_limit_s, {1.0, 120.0}, "s", "and how long at most");
        f.number("turn_s", turn_s, {1.0, 60.0}, "s", "turn: how long");
        f.number("go_to_s", go_to_s, {5.0, 250.0}, "s", "go_to: how long");
        f.number("go_to_half_area", go_to_half_area, {1.0, 6.0}, "m",
                 "go_to, localise: half the side of the square that the targets are in");
        f.number("go_to_shortest", go_to_shortest, {0.5, 60.0}, "s",
                 "go_to, localise: shortest time with one target");
        f.number("go_to_longest", go_to_longest, {0.5, 60.0}, "s", "and the longest");
        f.number("go_to_reached", go_to_reached, {0.05, 2.0}, "m",
                 "go_to: this near to the target its way is over");
        f.number("localise_s", localise_s, {5.0, 250.0}, "s", "localise: how long");
        f.number("kidnap_every_s", kidnap_every_s, {0.0, 250.0}, "s",
                 "localise: time from one kidnap to the next; 0 = none");
        f.number("fall_every_s", fall_every_s, {0.0, 250.0}, "s",
                 "localise: time from one fall to the next; 0 = none");
        f.number("ball_distance", ball_distance, {0.3, 8.0}, "m", "kick: from robot to ball");
        f.number("ball_bearing_deg", ball_bearing_deg, {0.0, 180.0}, "deg",
                 "kick: the ball lies up to this far off straight ahead");
        f.number("target_distance", target_distance, {1.0, 12.0}, "m", "kick: from ball to target");
        f.number("target_turn_deg", target_turn_deg, {0.0, 180.0}, "deg",
                 "kick: the target lies up to this far off the line from robot to ball");
        f.number("kick_limit_s", kick_limit_s, {1.0, 200.0}, "s",
                 "kick, kick_task, intercept, ball_rolls: time until the ball must be kicked");
        f.number("roll_least", roll_least, {0.1, 10.0}, "m/s",
                 "ball_rolls, intercept: slowest ball");
        f.number("roll_most", roll_most, {0.1, 10.0}, "m/s", "and the fastest");
        f.boolean("roll_kicked", roll_kicked,
                  "ball_rolls: with odd seeds a second robot kicks the ball");
    }
};

/// Empty text means: left to the program that is started.
struct DrillSpec {
    std::string name = "walk";
    int runs = 10;
    int first = 0;
    std::uint64_t seed = 1;
    int type = 0;
    std::string pace;
    std::string scenarios = "train";
    DrillSetup setup;
    std::string server_config;
    std::string agent_config;
    std::string settings;
    int http_port = -1;
    std::string results;
    std::string log_folder;
    double patience_s = 30.0;
    std::string server_program;
    std::string agent_program;
    std::string host = "127.0.0.1";
    int agent_port = 0;
    int server_port = 0;

    void describe(config::Fields& f) {
        f.text("name", name, kDrillNames, "what is drilled");
        f.integer("runs", runs, {1, 1000000}, "", "runs, each with new processes");
        f.integer("first", first, {0, 1000000}, "", "runs that count as played before: the first one has seed + first");
        f.seed("seed", seed, "of the first run; run k uses seed + k - 1");
        f.integer("type", type, {0, 4}, "", "type of Nao");
        f.text("pace", pace, {"", "realtime", "sync", "fast"},
               "as the server's; empty: fast, and sync with a page");
        f.text("scenarios", scenarios, {"train", "validation", "test"},
               "kick_task: which table; run k plays its scenario (k - 1) mod 12");
        f.section("setup", setup);
        f.text("server_config", server_config, {}, "TOML file, passed on to k3d-server");
        f.text("agent_config", agent_config, {}, "TOML file, passed on to k3d-agent");
        f.text(
            "settings", settings, {},
            "words PROGRAM:path=value passed on as --set path=value, PROGRAM server, agent, keeper "
            "(the robot that is measured) or taker (a second one)");
        f.integer("http_port", http_port, {-1, 65535}, "", "of the page; 0 = any, -1 = no page");
        f.text("results", results, {}, "file for one EpisodeResult line per run");
        f.text("log_folder", log_folder, {},
               "logs of all processes, kept; empty: a temporary one, kept for failed runs only");
        f.number("patience_s", patience_s, {0.1, 3600.0}, "s", "wall time to wait for an answer");
        f.text("server_program", server_program, {}, "empty: k3d-server beside this program");
        f.text("agent_program", agent_program, {}, "empty: k3d-agent beside this program");
        f.text("host", host, {}, "where a server runs already, if agent_port is given");
        f.integer("agent_port", agent_port, {0, 65535}, "",
                  "of a server that runs already; 0: a new server for each run");
        f.integer("server_port", server_port, {0, 65535}, "", "its monitor port");
    }
};

/// What no single field can tell: throws std::invalid_argument naming the value.
void check(const DrillSpec& spec);

}  // namespace k3d::optimizer::spec
