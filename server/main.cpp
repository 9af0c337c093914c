// SPDX-License-Identifier: BSD-3-Clause
// k3d-server: command line to configuration, and the run.
#include <CLI/CLI.hpp>

#include <csignal>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "common/config/config.h"
#include "common/log/log.h"
#include "common/version/version.h"
#include "server/cycle.h"

namespace {

volatile std::sig_atomic_t stop_requested = 0;

constexpr int kExitFailed = 1;
constexpr int kExitUsage = 2;
constexpr int kExitAgentLost = 3;

/// What the command line asks for beyond the configuration.
struct Options {
    std::vector<std::string> config_files;
    std::vector<std::pair<std::string, std::string>> settings;  ///< path, value
    std::string results;
    std::string web_folder;
    std::string log_level = "info";
    bool print_config = false;
};

/// Flags that are short names of configuration paths.
const std::vector<std::array<const char*, 3>> kFlags{
    {"--agent-port", "network.agent_port", "port for agents, 0 = any (default 3100)"},
    {"--server-port", "network.server_port", "port for trainers, 0 = any (default 3200)"},
    {"--http", "network.http_port", "port of the page, 0 = any (default: no page)"},
    {"--listen", "network.listen", "address to listen on (default 127.0.0.1)"},
    {"--pace", "pace.mode", "realtime, sync or fast (default realtime)"},
    {"--hung-agent-s", "pace.hung_agent", "wall seconds an agent may keep others waiting"},
    {"--lobby-s", "pace.lobby", "wall seconds until all keepaway seats must be taken, 0 = ever"},
    {"--game", "game", "soccer or keepaway (default soccer)"},
    {"--seed", "seed", "seed of all random streams"},
    {"--episodes", "episodes", "keepaway episodes to play before the server ends"},
    {"--left-team", "left_team", "team name reserved for the left side"},
    {"--right-team", "right_team", "team name reserved for the right side"},
    {"--keepers", "keepaway.keepers", "keepers in keepaway"},
    {"--takers", "keepaway.takers", "takers in keepaway"},
    {"--vision-interval", "vision.interval", "cycles between See percepts (default 3)"},
};

void add_flags(CLI::App& app, Options& options) {
    for (const auto& [flag, path, help] : kFlags) {
        app.add_option_function<std::string>(
            flag,
            [&options, where = std::string(path)](const std::string& value) {
                options.settings.emplace_back(where, value);
            },
            help);
    }
    app.add_option_function<std::string>(
           "--noise",
           [&options](const std::string& value) {
               if (value == "on") return;
               options.settings.emplace_back("vision.noise", "false");
               options.settings.emplace_back("beam.noise_xy", "0.0");
               options.settings.emplace_back("beam.noise_angle_deg", "0.0");
           },
           "on, or off: neither vision nor beams are noisy")
        ->check(CLI::IsMember({"on", "off"}));
    app.add_flag_callback(
        "--ground-truth",
        [&options] { options.settings.emplace_back("vision.ground_truth", "true"); },
        "adds mypos, myorien and ballpos to See");
    app.add_option("--config", options.config_files, "TOML file; may be repeated, later wins");
    app.add_option_function<std::vector<std::string>>(
        "--set",
        [&options](const std::vector<std::string>& values) {
            for (const std::string& value : values) {
                const auto equals = value.find('=');
                if (equals == std::string::npos) {
                    throw CLI::ValidationError("--set", "'" + value + "' is not path=value");
                }
                options.settings.emplace_back(value.substr(0, equals), value.substr(equals + 1));
            }
        },
        "path=value, e.g. keepaway.side=12; may be repeated");
    app.add_option("--results", options.results, "file to append one JSON line per episode to");
    app.add_option("--web-folder", options.web_folder, "folder of the page (default ../web)");
    app.add_option("--log-level", options.log_level, "trace, debug, info, warning, error or off");
    app.add_flag("--print-config", options.print_config, "print the resolved configuration, end");
}

k3d::server::Config resolve(const Options& options) {
    k3d::server::Config config;
    const auto describe = k3d::config::describing(config);
    for (const std::string& file : options.config_files) k3d::config::load_file(describe, file);
    for (const auto& [path, value] : options.settings) k3d::config::set(describe, path, value);
    return config;
}

std::string default_web_folder() {
    return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / "../web").string();
}

int run(const Options& options) {
    k3d::log::start("k3d-server", options.log_level);
    const k3d::server::Config config = resolve(options);
    if (options.print_config) {
        k3d::server::Config copy = config;
        std::cout << k3d::config::print(k3d::config::describing(copy));
        return 0;
    }
    k3d::server::Simulation simulation(
        config, options.results,
        options.web_folder.empty() ? default_web_folder() : options.web_folder);
    std::signal(SIGINT, [](int) { stop_requested = 1; });
    std::signal(SIGTERM, [](int) { stop_requested = 1; });
    std::signal(SIGPIPE, SIG_IGN);
    std::cout << simulation.ready_line() << std::endl;
    const k3d::server::Outcome outcome = simulation.run(stop_requested);
    return outcome == k3d::server::Outcome::AgentLost ? kExitAgentLost : 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"k3d-server: SimSpark-protocol server for simulated Nao robots"};
    app.set_version_flag("--version", std::string(k3d::code_version()));
    Options options;
    add_flags(app, options);
    try {
        app.parse(argc, argv);
        return run(options);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : kExitUsage;
    } catch (const k3d::config::ConfigError& error) {
        std::cerr << error.what() << '\n';
        return kExitUsage;
    } catch (const std::invalid_argument& error) {
        std::cerr << error.what() << '\n';
        return kExitUsage;
    } catch (const std::exception& error) {
        std::cerr << "k3d-server: " << error.what() << '\n';
        return kExitFailed;
    }
}
