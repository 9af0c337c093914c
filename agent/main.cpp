// SPDX-License-Identifier: BSD-3-Clause
// k3d-agent: command line to configuration, the handshake with the server, and the loop.
#include <CLI/CLI.hpp>

#include <chrono>
#include <csignal>
#include <string>
#include <vector>

#include "agent/config.h"
#include "agent/think.h"
#include "common/config/command_line.h"
#include "common/log/log.h"
#include "common/net/net.h"
#include "common/network/network.h"
#include "common/version/version.h"

namespace {

/// Frames after which a server that wanted us would have told side and number (reference 1.5).
constexpr int kFramesUntilSeated = 250;

struct Options {
    std::string host = "127.0.0.1";
    std::uint16_t port = 3100;
    std::string socket;  ///< Unix-domain; empty: host and port
    k3d::agent::Seat seat{"Keepers", 0};
    std::string telemetry;
    k3d::config::CommandLine line;
};

/// Flags that are short names of configuration paths.
const std::vector<k3d::config::ShortFlag> kFlags{
    {"--type", "robot_type", "type of Nao, 0-4 (default 0)"},
    {"--role", "role", "keeper, taker, drill, soccer or auto: left keeps, right takes (default auto)"},
    {"--keeper-policy", "keeper.policy", "handcoded, still, hold, random or a network file"},
    {"--taker", "taker.strategy", "greedy or greedy_random (default greedy)"},
    {"--keepers", "keepaway.keepers", "keepers in the game (default 3)"},
    {"--takers", "keepaway.takers", "takers in the game (default 2)"},
    {"--seed", "seed", "seed of the agent's random streams"},
    {"--patience-s", "patience", "seconds to wait for the server (default 60)"},
};

void check_team(const std::string& team) {
    if (team.empty()) throw CLI::ValidationError("--team", "the name is empty");
    for (const char c : team)
        if (c <= ' ' || c > '~' || c == '(' || c == ')')
            throw CLI::ValidationError(
                "--team", "'" + team + "' has a blank, a parenthesis or a byte outside ASCII");
}

void add_flags(CLI::App& app, Options& options) {
    app.add_option("--host", options.host, "server (default 127.0.0.1)");
    app.add_option("--port", options.port, "its agent port (default 3100)")
        ->check(CLI::Range(1, 65535));
    app.add_option("--socket", options.socket,
                   "the server's Unix-domain socket, in place of host and port");
    app.add_option("--unum", options.seat.unum, "number 1-11, 0 = any free one (default)")
        ->check(CLI::Range(0, 11));
    app.add_option_function<std::string>(
        "--team",
        [&options](const std::string& team) {
            check_team(team);
            options.seat.team = team;
        },
        "team name (default Keepers)");
    k3d::config::add_flags(app, options.line, kFlags, "keeper.hold_threshold=2.5");
    app.add_option("--telemetry", options.telemetry,
                   "file for beliefs and decisions, one JSON object a line");
}

/// Scene, one percept, then init (reference 1.5); `(syn)` in each frame for sync pace.
bool shake_hands(k3d::net::Client& client, const Options& options, const k3d::agent::Config& config,
                 std::chrono::milliseconds patience) {
    std::string out;
    k3d::wire::Commands scene;
    scene.scene = {"rsg/agent/nao/nao_hetero.rsg", {std::to_string(config.robot_type)}};
    scene.syn = true;
    k3d::wire::encode(scene, out);
    client.send(out);

    std::string_view payload;
    if (!client.receive(payload, patience)) return false;
    k3d::wire::Commands init;
    init.init = {options.seat.unum, options.seat.team};
    init.syn = true;
    out.clear();
    k3d::wire::encode(init, out);
    client.send(out);
    return true;
}

int play(const Options& options, const k3d::agent::Config& config) {
    k3d::agent::Mind mind(config, options.seat, options.telemetry);
    const auto patience = std::chrono::milliseconds(static_cast<long>(config.patience * 1000.0));
    k3d::net::Client client = options.socket.empty()
                                  ? k3d::net::Client(options.host, options.port, patience)
                                  : k3d::net::Client(k3d::net::UnixPath{options.socket}, patience);
    if (!shake_hands(client, options, config, patience)) return 0;

    std::string_view payload;
    std::string reply;
    for (long frames = 0; client.receive(payload, patience); ++frames) {
        mind.think(payload, reply);
        client.send(reply);
        if (frames == kFramesUntilSeated && mind.side() == k3d::wire::Side::None)
            throw k3d::net::NetError("the server gave no place to number " +
                                     std::to_string(options.seat.unum) + " of team " +
                                     options.seat.team + ": number taken, team full, or a third team");
    }
    return 0;
}

int run(const Options& options) {
    k3d::log::start("k3d-agent", options.line.log_level);
    k3d::agent::Config config;
    k3d::config::resolve(options.line, k3d::config::describing(config));
    if (k3d::config::print_wanted(options.line, k3d::config::describing(config))) return 0;
    std::signal(SIGPIPE, SIG_IGN);
    return play(options, config);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"k3d-agent: plays one simulated Nao on a SimSpark-protocol server"};
    app.set_version_flag("--version", std::string(k3d::code_version()));
    Options options;
    add_flags(app, options);
    return k3d::config::run_program(app, argc, argv, "k3d-agent", [&] { return run(options); });
}
