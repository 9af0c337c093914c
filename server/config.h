// SPDX-License-Identifier: BSD-3-Clause
// Everything that can be set of the server: TOML sections, and the flags that override them.
#pragma once

#include <cstdint>
#include <string>

#include "common/config/fields.h"
#include "common/net/net.h"
#include "server/effectors/beam.h"
#include "server/effectors/self_collision.h"
#include "server/game/keepaway/config.h"
#include "server/game/soccer/soccer.h"
#include "server/percepts/vision.h"
#include "server/physics/world.h"

namespace k3d::server {

struct NetworkConfig {
    std::string listen = "127.0.0.1";
    int agent_port = 3100;
    std::string agent_socket;
    int server_port = 3200;
    int http_port = -1;
    std::string trainers = "all";
    // What one peer of the agent or the trainer port may cost; beyond it, it is disconnected.
    int max_connections = 64;
    int max_frame = 65536;
    int max_cycle_bytes = 262144;
    int max_cycle_frames = 1000;
    int max_unread = 262144;
    int max_unsent = 1048576;
    double handshake = 30.0;

    void describe(config::Fields& f) {
        f.text("listen", listen, {}, "address of all ports");
        f.integer("agent_port", agent_port, {0, 65535}, "", "for agents; 0 = any free port");
        f.text("agent_socket", agent_socket, {},
               "file of a Unix-domain socket on which agents of this machine may connect, too; it takes less "
               "time than TCP");
        f.integer("server_port", server_port, {0, 65535}, "", "for monitors and trainers; 0 = any free port");
        f.integer("http_port", http_port, {-1, 65535}, "", "for the page; 0 = any, -1 = no page");
        f.text("trainers", trainers, {"all", "loopback", "off"},
               "who may command at the server port: all peers, those of this machine, nobody; "
               "anybody may watch");
        f.integer("max_connections", max_connections, {1, 1000}, "",
                  "open at a time at each port; further ones are refused");
        f.integer("max_frame", max_frame, {1024, 1048576}, "bytes", "that one frame may have");
        f.integer("max_cycle_bytes", max_cycle_bytes, {1024, 67108864}, "bytes",
                  "that one peer may send in a cycle");
        f.integer("max_cycle_frames", max_cycle_frames, {1, 1000000}, "",
                  "frames that one peer may send in a cycle");
        f.integer("max_unread", max_unread, {1024, 67108864}, "bytes",
                  "of one peer that wait for their cycle; beyond it TCP holds the peer back");
        f.integer("max_unsent", max_unsent, {0, 1073741824}, "bytes",
                  "of frames dropped in a row because an agent reads nothing; 0 = for ever. A "
                  "trainer need never read");
        f.number("handshake", handshake, {0.1, 86400.0}, "s",
                 "wall time in which a connected agent must have taken a seat");
    }

    net::Limits agent_limits() const {
        return {static_cast<std::size_t>(max_connections), static_cast<std::size_t>(max_frame),
                static_cast<std::size_t>(max_cycle_bytes),
                static_cast<std::size_t>(max_cycle_frames), static_cast<std::size_t>(max_unsent),
                static_cast<std::size_t>(max_unread)};
    }
    /// Trainers write and need not read (reference 1.8).
    net::Limits trainer_limits() const {
        net::Limits limits = agent_limits();
        limits.unsent = 0;
        return limits;
    }
};

struct MonitorConfig {
    double log_interval = 0.2;
    double log_full_interval = 3.0;

    void describe(config::Fields& f) {
        f.number("log_interval", log_interval, {0.02, 60.0}, "s",
                 "simulated time between two frames of the monitor log");
        f.number("log_full_interval", log_full_interval, {0.02, 3600.0}, "s",
                 "simulated time between its full frames, to which viewers can jump");
    }
};

struct PaceConfig {
    std::string mode = "realtime";
    double hung_agent = 30.0;
    double lobby = 0.0;
    int lobby_left = 0;
    int lobby_right = 0;

    void describe(config::Fields& f) {
        f.text("mode", mode, {"realtime", "sync", "fast"},
               "realtime: wall clock, waits for nobody; sync: waits for every agent's (syn), at "
               "most wall-clock speed; fast: waits for every agent, no clock");
        f.number("hung_agent", hung_agent, {0.1, 3600.0}, "s",
                 "wall time an agent may keep the others waiting");
        f.integer("lobby_left", lobby_left, {0, 11}, "players",
                  "soccer: the clock starts when exactly so many play on the left, so that connect "
                  "times leave no trace; 0 on both sides: it runs at once, for all 11");
        f.integer("lobby_right", lobby_right, {0, 11}, "players", "the same on the right");
        f.number("lobby", lobby, {0.0, 86400.0}, "s",
                 "wall time in which all seats waited for must be taken; 0 = no limit");
    }
};

struct PhysicsConfig {
    std::string stepper = "exact";

    void describe(config::Fields& f) {
        f.text("stepper", stepper, {"exact", "fast"},
               "exact: dWorldStep, as the reference; fast: our own solver of the same equations, in a "
               "small part of its time");
    }
    physics::Stepper kind() const {
        return stepper == "fast" ? physics::Stepper::Fast : physics::Stepper::Exact;
    }
};

struct Config {
    std::string game = "soccer";
    std::uint64_t seed = 1;
    int episodes = 1;
    int first_episode = 1;
    std::string left_team;
    std::string right_team;
    std::string stage_times;
    NetworkConfig network;
    MonitorConfig monitor;
    PaceConfig pace;
    PhysicsConfig physics;
    percepts::VisionConfig vision;
    effectors::BeamConfig beam;
    effectors::SelfCollisionConfig self_collision;
    game::KeepawayConfig keepaway;
    game::SoccerConfig soccer;

    void describe(config::Fields& f) {
        f.text("game", game, {"soccer", "keepaway"}, "rules in force");
        f.seed("seed", seed, "of all random streams; episode k of a process uses seed + k - 1");
        f.integer("episodes", episodes, {1, 1000000}, "",
                  "episodes before the server ends: keepaway's, and soccer's with a lobby");
        f.integer("first_episode", first_episode, {1, 1000000000}, "",
                  "number that the page shows for this process's first episode");
        f.text("left_team", left_team, {}, "name reserved for the left side; empty: first come");
        f.text("right_team", right_team, {}, "name reserved for the right side; empty: second come");
        f.text("stage_times", stage_times, {},
               "file to write the CPU time of each stage of the cycles to, at the end; empty: not "
               "measured");
        f.section("network", network);
        f.section("monitor", monitor);
        f.section("pace", pace);
        f.section("physics", physics);
        f.section("vision", vision);
        f.section("beam", beam);
        f.section("self_collision", self_collision);
        f.section("keepaway", keepaway);
        f.section("soccer", soccer);
    }
};

}  // namespace k3d::server
