// SPDX-License-Identifier: BSD-3-Clause
// What a match run is: everything that decides its lines, and how it is carried out.
#pragma once

#include <cstdint>
#include <string>

#include "common/config/fields.h"

namespace k3d::optimizer::spec {

/// Empty text means: left to the program that is started.
struct MatchSpec {
    // What is played: with a pace that waits for agents, the results follow from these alone.
    int episodes = 1;
    std::uint64_t seed = 1;
    int keepers = 3;
    int takers = 2;
    std::string keeper_policy;
    std::string taker = "greedy";
    std::string pace = "fast";
    std::string keeper_command;
    std::string taker_command;
    std::string server_config;
    std::string agent_config;
    std::string settings;
    // How it is carried out.
    int jobs = 1;
    bool one_process = false;
    int retries = 3;
    double deadline_s = 1800.0;
    double lobby_s = 60.0;
    double hung_agent_s = 30.0;
    int http_port = -1;
    std::string results;
    std::string log_folder;
    std::string server_program;
    std::string agent_program;

    void describe(config::Fields& f) {
        f.integer("episodes", episodes, {1, 1000000}, "", "episodes that must give a result");
        f.seed("seed", seed, "of the first episode; episode k of the run uses seed + k - 1");
        f.integer("keepers", keepers, {1, 11}, "players", "left team");
        f.integer("takers", takers, {1, 11}, "players", "right team");
        f.text("keeper_policy", keeper_policy, {}, "name or file, as k3d-agent --keeper-policy");
        f.text("taker", taker, {"greedy", "greedy_random"},
               "greedy: all chase the ball; greedy_random: all but one follow a random keeper");
        f.text("pace", pace, {"realtime", "sync", "fast"},
               "as the server's; only sync and fast give the same lines again");
        f.text("keeper_command", keeper_command, {},
               "program for the keepers' seats; {host} {port} {unum} {team} are filled in");
        f.text("taker_command", taker_command, {}, "the same for the takers' seats");
        f.text("server_config", server_config, {}, "TOML file, passed on to k3d-server");
        f.text("agent_config", agent_config, {}, "TOML file, passed on to every k3d-agent");
        f.text("settings", settings, {},
               "words PROGRAM:path=value passed on as --set path=value, PROGRAM one of server, "
               "agent, keeper, taker");
        f.integer("jobs", jobs, {1, 256}, "", "episodes at a time; no result depends on it");
        f.boolean("one_process", one_process,
                  "our own agents share a process: the same lines for less processor time");
        f.integer("retries", retries, {0, 100}, "",
                  "further tries of an episode that gave no valid result");
        f.number("deadline_s", deadline_s, {0.1, 86400.0}, "s", "wall time of one try");
        f.number("lobby_s", lobby_s, {0.1, 86400.0}, "s", "wall time until all seats are taken");
        f.number("hung_agent_s", hung_agent_s, {0.1, 3600.0}, "s",
                 "wall time an agent may keep the others waiting");
        f.integer("http_port", http_port, {-1, 65535}, "", "of the page; 0 = any, -1 = no page");
        f.text("results", results, {}, "file for one EpisodeResult line per episode");
        f.text("log_folder", log_folder, {},
               "logs of all processes, kept; empty: a temporary one, kept for failed tries only");
        f.text("server_program", server_program, {}, "empty: k3d-server beside this program");
        f.text("agent_program", agent_program, {}, "empty: k3d-agent beside this program");
    }
};

/// A foreign program's command: empty, or words with known {placeholders}. Throws
/// std::invalid_argument naming `field` and the value.
void check_command(const char* field, const std::string& command);

/// What no single field can tell: throws std::invalid_argument naming the value.
void check(const MatchSpec& spec);

}  // namespace k3d::optimizer::spec
