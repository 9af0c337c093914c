// SPDX-License-Identifier: BSD-3-Clause
// k3d-server: command line to configuration, and the run.
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <csignal>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "common/config/command_line.h"
#include "common/log/log.h"
#include "common/version/version.h"
#include "server/cycle.h"

namespace {

volatile std::sig_atomic_t stop_requested = 0;

constexpr int kExitAgentLost = 3;
constexpr int kExitDiffers = 4;
constexpr int kExitDamaged = 5;

/// What the command line asks for beyond the configuration.
struct Options {
    k3d::config::CommandLine line;
    k3d::server::Files files;
    std::string replayed;  ///< recording; empty: a live run
};

/// Flags that are short names of configuration paths.
const std::vector<k3d::config::ShortFlag> kFlags{
    {"--agent-port", "network.agent_port", "port for agents, 0 = any"},
    {"--agent-socket", "network.agent_socket",
     "Unix-domain socket for agents of this machine, too"},
    {"--server-port", "network.server_port", "port for monitors and trainers, 0 = any"},
    {"--trainers", "network.trainers", "who may command there: all, loopback or off"},
    {"--http", "network.http_port", "port of the page, 0 = any, -1 = no page"},
    {"--listen", "network.listen", "address to listen on"},
    {"--pace", "pace.mode", "realtime, sync or fast"},
    {"--stepper", "physics.stepper", "exact or fast"},
    {"--hung-agent-s", "pace.hung_agent", "wall seconds an agent may keep others waiting"},
    {"--lobby-s", "pace.lobby",
     "wall seconds until all seats waited for must be taken, 0 = for ever"},
    {"--game", "game", "soccer or keepaway"},
    {"--seed", "seed", "seed of all random streams"},
    {"--episodes", "episodes",
     "episodes to play before the server ends (keepaway, and soccer with a lobby)"},
    {"--left-team", "left_team", "team name reserved for the left side"},
    {"--right-team", "right_team", "team name reserved for the right side"},
    {"--keepers", "keepaway.keepers", "keepers in keepaway"},
    {"--takers", "keepaway.takers", "takers in keepaway"},
    {"--vision-interval", "vision.interval", "cycles between See percepts"},
};

/// Flags that set several paths.
void add_groups(CLI::App& app, Options& options) {
    auto& settings = options.line.settings;
    app.add_option_function<std::string>(
           "--noise",
           [&settings](const std::string& value) {
               if (value == "on") return;
               settings.emplace_back("vision.noise", "false");
               settings.emplace_back("beam.noise_xy", "0.0");
               settings.emplace_back("beam.noise_angle_deg", "0.0");
           },
           "on, or off: neither vision nor beams are noisy")
        ->check(CLI::IsMember({"on", "off"}));
    app.add_flag_callback(
        "--ground-truth",
        [&settings] {
            for (const char* name : {"my_position", "my_orientation", "ball_position"}) {
                settings.emplace_back(std::string("vision.") + name, "true");
            }
        },
        "adds mypos, myorien and ballpos to See");
}

void add_flags(CLI::App& app, Options& options) {
    add_groups(app, options);  // before --set, which wins over them
    k3d::server::Config defaults;
    k3d::config::add_flags(app, options.line, kFlags, "keepaway.side=12",
                           k3d::config::describing(defaults));
    app.add_option("--results", options.files.results, "file to append one JSON line per episode to");
    app.add_option("--monitor-log", options.files.monitor_log,
                   "file to write the match to, for monitors to play");
    app.add_option("--record", options.files.record,
                   "file to write everything that comes in to, for `replay`");
    app.add_option("--beliefs", options.files.beliefs,
                   "folder in which agents write telemetry, drawn on the page over the truth")
        ->check(CLI::ExistingDirectory);
    app.add_option("--web-folder", options.files.web_folder, "folder of the page (default ../web)");
}

int run(const Options& options) {
    k3d::log::start("k3d-server", options.line.log_level);
    k3d::server::Config config;
    k3d::config::resolve(options.line, k3d::config::describing(config));
    if (k3d::config::print_wanted(options.line, k3d::config::describing(config))) return 0;
    k3d::server::Files files = options.files;
    if (files.web_folder.empty()) {
        files.web_folder = k3d::server::viewer::web_folder_beside_program();
    }
    k3d::server::Simulation simulation(config, files);
    const std::string ready = simulation.open_ports();
    simulation.open_files();
    std::signal(SIGINT, [](int) { stop_requested = 1; });
    std::signal(SIGTERM, [](int) { stop_requested = 1; });
    std::signal(SIGPIPE, SIG_IGN);
    std::cout << ready << std::endl;
    const k3d::server::Outcome outcome = simulation.run(stop_requested);
    return outcome == k3d::server::Outcome::AgentLost ? kExitAgentLost : 0;
}

/// What `replay` found, in one line; the exit code.
int report(const std::string& file, const k3d::server::ReplayOutcome& outcome, bool complete) {
    const std::string place =
        fmt::format("cycle {} ({:.2f} s, episode {})", outcome.reached.count,
                    outcome.reached.seconds(), outcome.episode);
    if (outcome.differs) {
        std::cout << fmt::format("{}: {} differs from what was recorded\n", file, place);
        return kExitDiffers;
    }
    if (outcome.ended_early) {
        std::cout << fmt::format("{}: the run ends at {}, what was recorded goes on\n", file, place);
        return kExitDiffers;
    }
    std::cout << fmt::format("{}: all {} steps up to {} replay equal{}\n", file, outcome.steps, place,
                             complete ? "" : "; the recording has no end, its server was killed");
    return 0;
}

/// A replay has the configuration of its recording: flags of a live run, which stand before the
/// command, would be ignored, or, as --record, destroy the recording.
void refuse_flags_of_a_live_run(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options()) {
        if (option->count() == 0) continue;
        throw std::invalid_argument(fmt::format(
            "{}: no flag may stand before replay; its own stand behind it", option->get_name()));
    }
}

void refuse_to_overwrite(const std::string& recording, const k3d::server::Files& files) {
    for (const auto& [flag, file] :
         {std::pair("--results", files.results), std::pair("--monitor-log", files.monitor_log)}) {
        std::error_code none_yet;
        if (!std::filesystem::equivalent(recording, file, none_yet)) continue;
        throw std::invalid_argument(fmt::format("{}: {} is the recording", flag, file));
    }
}

int replay(const Options& options) {
    k3d::log::start("k3d-server", options.line.log_level);
    const std::string& file = options.replayed;
    refuse_to_overwrite(file, options.files);
    k3d::server::ReplayOutcome outcome;
    try {
        k3d::server::recording::Replay recording(file);
        const auto& header = recording.header();
        if (header.code_version != k3d::code_version()) {
            std::cout << fmt::format("{}: recorded by {}, replayed by {}\n", file,
                                     header.code_version, k3d::code_version());
        }
        k3d::server::Config config;
        k3d::config::load_text(k3d::config::describing(config), header.config,
                               "configuration in " + file);
        config.stage_times.clear();  // those of the run that was recorded stay
        k3d::server::Simulation simulation(config, options.files);
        simulation.open_files();
        simulation.replay(recording, outcome);
        return report(file, outcome, recording.complete());
    } catch (const k3d::server::recording::RecordError& error) {
        std::cerr << fmt::format("k3d-server: {} (the {} steps before it replay equal)\n",
                                 error.what(), outcome.steps);
        return kExitDamaged;
    }
}

void add_replay(CLI::App& app, Options& options) {
    CLI::App* command = app.add_subcommand(
        "replay", "re-simulates a recording and names the first cycle that differs");
    command->add_option("file", options.replayed, "what --record wrote")
        ->required()
        ->check(CLI::ExistingFile);
    command->add_option("--results", options.files.results,
                        "file to append one JSON line per episode to");
    command->add_option("--monitor-log", options.files.monitor_log,
                        "file to write the match to, for monitors to play");
    command->add_option("--log-level", options.line.log_level,
                        "trace, debug, info, warning, error or off");
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"k3d-server: SimSpark-protocol server for simulated Nao robots"};
    app.set_version_flag("--version", std::string(k3d::code_version()));
    Options options;
    add_flags(app, options);
    add_replay(app, options);
    return k3d::config::run_program(app, argc, argv, "k3d-server", [&] {
        if (options.replayed.empty()) return run(options);
        refuse_flags_of_a_live_run(app);
        return replay(options);
    });
}
