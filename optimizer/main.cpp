// SPDX-License-Identifier: BSD-3-Clause
// k3d-optimizer: command line to specification, one subcommand each.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "common/config/command_line.h"
#include "common/log/log.h"
#include "common/version/version.h"
#include "optimizer/bench.h"
#include "optimizer/drill_run.h"
#include "optimizer/hopeless.h"
#include "optimizer/match.h"
#include "optimizer/report/progress.h"
#include "optimizer/report/table.h"
#include "optimizer/reproduce.h"
#include "optimizer/spec/match_spec.h"
#include "optimizer/spec/words.h"
#include "optimizer/verbs.h"

namespace {

using k3d::optimizer::spec::MatchSpec;

/// What a command line asks for: files first, then what the flags say.
struct Options {
    std::vector<std::string> config_files;
    std::vector<std::pair<std::string, std::string>> fields;  ///< key, value
    std::string settings;
    bool print_config = false;
};

/// Flags of `match` that set a field of its specification.
const std::vector<k3d::config::ShortFlag> kMatchFlags{
    {"--episodes", "episodes", "episodes to play (default 1)"},
    {"--seed", "seed", "of the first episode, the next ones count up (default 1)"},
    {"--jobs", "jobs", "episodes at a time; no result depends on it (default 1)"},
    {"--keepers", "keepers", "keepers (default 3)"},
    {"--takers", "takers", "takers (default 2)"},
    {"--keeper-policy", "keeper_policy", "how keepers decide: a name or a file, as k3d-agent's"},
    {"--taker", "taker", "greedy or greedy_random (default greedy)"},
    {"--pace", "pace", "realtime, sync or fast (default fast)"},
    {"--keeper-command", "keeper_command",
     "program for the keepers' seats; {host} {port} {unum} {team} are filled in; no shell"},
    {"--taker-command", "taker_command", "the same for the takers' seats"},
    {"--server-config", "server_config", "TOML file for k3d-server"},
    {"--agent-config", "agent_config", "TOML file for every k3d-agent"},
    {"--results", "results", "file for one EpisodeResult line per episode"},
    {"--log-folder", "log_folder",
     "keep all logs here (default: a temporary folder, kept for failed tries)"},
    {"--retries", "retries", "further tries of an episode without a valid result (default 3)"},
    {"--deadline-s", "deadline_s", "wall seconds one try may take (default 1800)"},
    {"--lobby-s", "lobby_s", "wall seconds until all seats must be taken (default 60)"},
    {"--hung-agent-s", "hung_agent_s",
     "wall seconds an agent may keep others waiting (default 30)"},
};

void add_match_flags(CLI::App& match, Options& options) {
    for (const auto& [flag, key, help] : kMatchFlags) {
        match.add_option_function<std::string>(
            flag,
            [&options, field = std::string(key)](const std::string& value) {
                options.fields.emplace_back(field, value);
            },
            help);
    }
    CLI::Option* http = match.add_option_function<std::string>(
        "--http",
        [&options](const std::string& value) { options.fields.emplace_back("http_port", value); },
        "port of the page, 0 = any (default: no page)");
    match
        .add_flag_callback(
            "--no-viewer", [&options] { options.fields.emplace_back("http_port", "-1"); },
            "no page")
        ->excludes(http);
    match.add_flag_callback(
        "--one-process", [&options] { options.fields.emplace_back("one_process", "true"); },
        "our own agents share a process: the same lines for less processor time");
    match
        .add_option_function<std::vector<std::string>>(
            "--set",
            [&options](const std::vector<std::string>& values) {
                for (const std::string& value : values) {
                    options.settings += " " + k3d::optimizer::spec::quote_word(value);
                }
            },
            "PROGRAM:path=value for server, agent, keeper or taker, e.g. "
            "server:keepaway.side=12; may be repeated")
        ->allow_extra_args(false);
    match
        .add_option("--config", options.config_files,
                    "TOML file of these settings, as --print-config prints it; flags win")
        ->allow_extra_args(false);
    match.add_flag("--print-config", options.print_config, "print the resolved run, and end");
}

MatchSpec resolve(const Options& options) {
    MatchSpec spec;
    const auto describe = k3d::config::describing(spec);
    for (const std::string& file : options.config_files) k3d::config::load_file(describe, file);
    for (const auto& [key, value] : options.fields) k3d::config::set(describe, key, value);
    spec.settings += spec.settings.empty() && !options.settings.empty() ? options.settings.substr(1)
                                                                        : options.settings;
    k3d::optimizer::spec::check(spec);
    return spec;
}

int run_match(const Options& options) {
    MatchSpec spec = resolve(options);
    if (options.print_config) {
        std::cout << k3d::config::print(k3d::config::describing(spec));
        return 0;
    }
    k3d::optimizer::report::Progress progress(spec, std::cout, ::isatty(STDOUT_FILENO) == 1);
    const auto run = k3d::optimizer::play_match(spec, progress);
    progress.end();
    std::cout << k3d::optimizer::report::table(spec, run);
    if (run.interrupted) return k3d::config::kExitInterrupted;
    return run.failures.empty() ? 0 : k3d::config::kExitFailed;
}

void add_bench(CLI::App& app, std::function<int()>& chosen) {
    CLI::App* verb = app.add_subcommand(
        "bench", "plays episodes with each stepper and prints simulated seconds per core-second");
    const auto settings = std::make_shared<k3d::optimizer::BenchSettings>();
    verb->add_option("--episodes", settings->episodes, "of each stepper (default 5)")
        ->check(CLI::Range(1, 1000));
    verb->add_option("--seed", settings->seed, "of the first one (default 1)");
    verb->add_option("--limit-s", settings->limit_s, "simulated seconds of one (default 30)")
        ->check(CLI::Range(1.0, 3600.0));
    verb->add_option("--keepers", settings->keepers, "keepers (default 3)")
        ->check(CLI::Range(1, 11));
    verb->add_option("--takers", settings->takers, "takers (default 2)")->check(CLI::Range(1, 11));
    verb->callback([&chosen, settings] {
        chosen = [settings] {
            std::cout << k3d::optimizer::bench(*settings);
            return 0;
        };
    });
}

/// A start failure that every try would meet keeps the exit code of whoever refused to start.
int guarded(const std::function<int()>& command) {
    try {
        return command();
    } catch (const k3d::optimizer::HopelessRun& error) {
        std::cerr << "k3d-optimizer: " << error.what() << '\n';
        return error.exit_code == k3d::config::kExitUsage ? k3d::config::kExitUsage
                                                          : k3d::config::kExitFailed;
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"k3d-optimizer: plays matches of keepaway, measures them, and learns from them"};
    app.set_version_flag("--version", std::string(k3d::code_version()));
    app.require_subcommand(0, 1);  // none is looked at below: then a misspelt one is named
    std::function<int()> chosen;
    Options match_options;
    CLI::App* match = app.add_subcommand(
        "match", "plays episodes of keepaway, each with new processes, and prints a table");
    add_match_flags(*match, match_options);
    match->callback([&] { chosen = [&match_options] { return run_match(match_options); }; });
    k3d::optimizer::add_drill_command(app, chosen);
    k3d::optimizer::add_run_verbs(app, chosen);
    k3d::optimizer::add_reproduce_verb(app, chosen);
    add_bench(app, chosen);
    return k3d::config::run_program(app, argc, argv, "k3d-optimizer", [&] {
        if (!chosen) throw std::invalid_argument("which subcommand? See k3d-optimizer --help");
        k3d::log::start("k3d-optimizer", "info");
        return guarded(chosen);
    });
}
