// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/drill_run.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <csignal>
#include <iostream>
#include <memory>
#include <optional>
#include <string_view>

#include "common/config/command_line.h"
#include "common/log/log.h"
#include "optimizer/backend/log_folder.h"
#include "optimizer/backend/wakeups.h"
#include "optimizer/drill/drill_process.h"
#include "optimizer/drill/play.h"
#include "optimizer/report/drill_table.h"
#include "optimizer/report/results_file.h"
#include "optimizer/spec/drill_spec.h"
#include "optimizer/spec/words.h"

namespace k3d::optimizer {

namespace {

const std::vector<config::ShortFlag> kFlags{
    {"--runs", "runs", "runs, each with new processes (default 10)"},
    {"--seed", "seed", "of the first run, the next ones count up (default 1)"},
    {"--type", "type", "type of Nao, 0-4 (default 0)"},
    {"--http", "http_port", "port of the page, 0 = any; then in real time (default: no page)"},
    {"--pace", "pace", "realtime, sync or fast"},
    {"--scenarios", "scenarios", "kick_task: train, validation or test"},
    {"--results", "results", "file for one EpisodeResult line per run"},
    {"--log-folder", "log_folder", "keep all logs here"},
    {"--server-config", "server_config", "TOML file for k3d-server"},
    {"--agent-config", "agent_config", "TOML file for k3d-agent"},
    {"--host", "host", "where a server runs already, with the two ports"},
    {"--agent-port", "agent_port", "its agent port (default: a new server for each run)"},
    {"--server-port", "server_port", "its monitor port"},
};

bool is_passed_on(const std::string& path) {
    constexpr std::array<std::string_view, 4> kPrograms{"server:", "agent:", "keeper:", "taker:"};
    return std::any_of(kPrograms.begin(), kPrograms.end(),
                       [&path](std::string_view program) { return path.starts_with(program); });
}

/// Settings of server and agents are passed on; the others are the drill's own.
spec::DrillSpec resolve(config::CommandLine line, const std::string& name) {
    spec::DrillSpec spec;
    std::string passed_on;
    std::erase_if(line.settings, [&](const auto& setting) {
        if (!is_passed_on(setting.first)) return false;
        passed_on += " " + spec::quote_word(setting.first + "=" + setting.second);
        return true;
    });
    const auto describe = config::describing(spec);
    config::resolve(line, describe);
    config::set(describe, "name", name);
    spec.settings += passed_on;
    spec::check(spec);
    return spec;
}

/// The exit code of a failure that all further runs would meet too; none if they may do better.
std::optional<int> ends_all(const std::runtime_error& error, bool first) {
    if (dynamic_cast<const process::StartError*>(&error) != nullptr) return drill::kExitCannotStart;
    const auto* failure = dynamic_cast<const drill::DrillFailure*>(&error);
    // What server or agent refuse is a mistake of whoever called this program.
    if (failure != nullptr && failure->refused) return config::kExitUsage;
    // A robot may have bad luck; what fails before one plays is a port or a file, and stays as it
    // is.
    if (failure != nullptr || !first) return std::nullopt;
    return config::kExitFailed;
}

/// The runs of a drill, one after the other.
class Runs {
  public:
    explicit Runs(const spec::DrillSpec& spec)
        : spec_(spec), logs_(spec.log_folder), lines_(spec.results), http_port_(spec.http_port) {}

    /// Plays them, prints the table and returns the exit code.
    int play() {
        std::optional<int> ended;
        for (int index = 0; index < spec_.runs && !ended; ++index) ended = play_one(index);
        const bool stopped = ended == config::kExitInterrupted;
        if (ended && !stopped && results_.empty()) return *ended;  // what is wrong has been said
        lines_.close();
        std::cout << report::drill_table(spec_, results_);
        if (ended) return *ended;
        const bool all = results_.size() == static_cast<std::size_t>(spec_.runs);
        return all ? 0 : config::kExitFailed;
    }

  private:
    /// An exit code if there is to be no further run.
    std::optional<int> play_one(int index) {
        if (stop_wanted()) return config::kExitInterrupted;
        const int number = spec_.first + index;
        const std::uint64_t seed = spec_.seed + static_cast<std::uint64_t>(number);
        const std::string folder = logs_.begin({index, seed, 1});
        try {
            results_.push_back(drill::play(spec_, number, folder, http_port_, listener_));
            logs_.end(folder, false);
            lines_.settle(index, results_.back());
        } catch (const drill::Stopped&) {
            logs_.end(folder, false);
            return config::kExitInterrupted;
        } catch (const std::runtime_error& error) {
            logs_.end(folder, true);
            lines_.settle(index, std::nullopt);
            std::cerr << fmt::format("run {}, seed {}: {}; logs in {}", index + 1, seed,
                                     error.what(), folder)
                      << std::endl;
            return ends_all(error, index == 0);
        }
        return std::nullopt;
    }

    void tell_page(int port) {
        if (http_port_ != port || results_.empty()) {
            std::cout << fmt::format("watch http://127.0.0.1:{}/", port) << std::endl;
        }
        http_port_ = port;  // the next run's page takes its place
    }
    bool stop_wanted() {
        wakeups_.wait(std::chrono::steady_clock::now());
        return wakeups_.stop_wanted();
    }

    const spec::DrillSpec& spec_;
    backend::Wakeups wakeups_;
    backend::LogFolder logs_;
    report::ResultsFile lines_;
    std::vector<k3d::episode::Result> results_;
    int http_port_;
    drill::Listener listener_{[this](int port) { tell_page(port); },
                              [this] { return stop_wanted(); }};
};

}  // namespace

void add_drill_command(CLI::App& app, std::function<int()>& chosen) {
    struct Options {
        std::string name;
        config::CommandLine line;
    };
    auto options = std::make_shared<Options>();
    CLI::App* drill = app.add_subcommand(
        "drill", "measures one skill of the agent against the truth, and prints a table");
    drill->add_option("name", options->name, "what is drilled")
        ->required()
        ->check(CLI::IsMember(spec::kDrillNames));
    config::add_flags(*drill, options->line, kFlags, "agent:motion.walk.max_forward=0.8");
    drill->callback([options, &chosen] {
        chosen = [options] {
            log::start("k3d-optimizer", options->line.log_level);
            spec::DrillSpec spec = resolve(options->line, options->name);
            if (options->line.print_config) {
                std::cout << config::print(config::describing(spec));
                return 0;
            }
            std::signal(SIGPIPE, SIG_IGN);
            return Runs(spec).play();
        };
    });
}

}  // namespace k3d::optimizer
