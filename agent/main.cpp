// SPDX-License-Identifier: BSD-3-Clause
// k3d-agent: command line to configuration, the handshake with the server, and the loop, for one agent or
// several in a process.
#include <CLI/CLI.hpp>

#include <chrono>
#include <csignal>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
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

constexpr std::string_view kAnd = "--and";  ///< between the flags of two agents

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

/// One agent: its mind, and its own connection to the server.
class Player {
  public:
    /// Opens the files that its settings name; the server hears nothing yet.
    Player(const Options& options, const k3d::agent::Config& config)
        : options_(options),
          robot_type_(config.robot_type),
          mind_(config, options.seat, options.telemetry),
          patience_(static_cast<long>(config.patience * 1000.0)) {}

    /// Connects and asks for a body: scene, then, once a percept came, init (reference 1.5);
    /// `(syn)` in each frame for sync pace.
    void connect() {
        if (options_.socket.empty()) {
            client_.emplace(options_.host, options_.port, patience_);
        } else {
            client_.emplace(k3d::net::UnixPath{options_.socket}, patience_);
        }
        k3d::wire::Commands scene;
        scene.scene = {"rsg/agent/nao/nao_hetero.rsg", {std::to_string(robot_type_)}};
        send(scene);
    }

    /// Takes the seat; false if the server has closed in order.
    bool sit_down() {
        std::string_view payload;
        if (!client_->receive(payload, patience_)) return false;
        k3d::wire::Commands init;
        init.init = {options_.seat.unum, options_.seat.team};
        send(init);
        return true;
    }

    /// One cycle; false if the server has closed in order.
    bool play_on() {
        std::string_view payload;
        if (!client_->receive(payload, patience_)) return false;
        mind_.think(payload, reply_);
        client_->send(reply_);
        if (frames_++ == kFramesUntilSeated && mind_.side() == k3d::wire::Side::None)
            throw k3d::net::NetError(
                "the server gave no place to number " + std::to_string(options_.seat.unum) +
                " of team " + options_.seat.team + ": number taken, team full, or a third team");
        return true;
    }

  private:
    void send(k3d::wire::Commands& commands) {
        commands.syn = true;
        reply_.clear();
        k3d::wire::encode(commands, reply_);
        client_->send(reply_);
    }

    const Options options_;
    int robot_type_;
    k3d::agent::Mind mind_;
    std::chrono::milliseconds patience_;
    std::optional<k3d::net::Client> client_;  ///< from connect() on
    std::string reply_;
    long frames_ = 0;
};

/// All in turn, each cycle, until the server has closed to the last one.
void play(std::vector<std::unique_ptr<Player>> players) {
    const auto leave = [&players](auto goes_on) {
        std::erase_if(players, [&](const auto& player) { return !goes_on(*player); });
    };
    leave([](Player& player) { return player.sit_down(); });
    while (!players.empty()) leave([](Player& player) { return player.play_on(); });
}

/// `all`: one agent's options each.
int run(const std::vector<Options>& all) {
    k3d::log::start("k3d-agent", all.front().line.log_level);
    std::signal(SIGPIPE, SIG_IGN);
    // What is wrong with anybody's settings ends all of them before the first one takes a seat.
    std::vector<k3d::agent::Config> configs(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        k3d::config::resolve(all[i].line, k3d::config::describing(configs[i]));
        if (k3d::config::print_wanted(all[i].line, k3d::config::describing(configs[i]))) return 0;
    }
    std::vector<std::unique_ptr<Player>> players;
    for (std::size_t i = 0; i < all.size(); ++i)
        players.push_back(std::make_unique<Player>(all[i], configs[i]));
    for (const auto& player : players) player->connect();
    play(std::move(players));
    return 0;
}

/// The words of each agent, the program's name before them.
std::vector<std::vector<char*>> split_at_and(int argc, char** argv) {
    std::vector<std::vector<char*>> out{{argv[0]}};
    for (int i = 1; i < argc; ++i) {
        if (std::string_view(argv[i]) == kAnd) {
            out.push_back({argv[0]});
        } else {
            out.back().push_back(argv[i]);
        }
    }
    return out;
}

/// Parses agent after agent, the first of `agents` next, and runs all; returns the exit code.
int parse_and_run(std::span<std::vector<char*>> agents, std::vector<Options>& parsed) {
    CLI::App app{"k3d-agent: plays one simulated Nao on a SimSpark-protocol server"};
    app.set_version_flag("--version", std::string(k3d::code_version()));
    app.footer(
        "FLAGS --and FLAGS: another agent in the same process, which costs less; each has its own "
        "connection and no word of the other.");
    Options options;
    add_flags(app, options);
    std::vector<char*>& words = agents.front();
    return k3d::config::run_program(
        app, static_cast<int>(words.size()), words.data(), "k3d-agent", [&] {
            if (!parsed.empty() && app.count("--log-level") > 0)
                throw std::invalid_argument(
                    "--log-level is of the whole process: say it before --and");
            parsed.push_back(options);
            return agents.size() == 1 ? run(parsed) : parse_and_run(agents.subspan(1), parsed);
        });
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::vector<char*>> agents = split_at_and(argc, argv);
    std::vector<Options> parsed;
    return parse_and_run(agents, parsed);
}
