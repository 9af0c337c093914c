// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/verbs.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "common/config/command_line.h"
#include "common/log/log.h"
#include "optimizer/backend/local_backend.h"
#include "optimizer/backend/nats_backend.h"
#include "optimizer/backend/worker.h"
#include "optimizer/daemon.h"
#include "optimizer/found.h"
#include "optimizer/report/run_report.h"
#include "optimizer/report/run_text.h"
#include "optimizer/run.h"
#include "optimizer/spec/words.h"

namespace k3d::optimizer {

namespace {

constexpr std::chrono::milliseconds kNatsAgain{500};

/// How a run is carried out; no result depends on it.
struct Carrier {
    int jobs = 1;
    std::string nats;  ///< empty: this machine
    double lease_s = 30.0;
    int http_port = -1;  ///< below 0: no page
    std::string listen = "127.0.0.1";
};

void add_carrier_flags(CLI::App& verb, Carrier& carrier) {
    CLI::Option* jobs =
        verb.add_option("--jobs", carrier.jobs, "episodes at a time on this machine (default 1)")
            ->check(CLI::Range(1, 256));
    verb.add_option("--nats", carrier.nats,
                    "nats-server whose workers play the episodes, e.g. nats://127.0.0.1:4222")
        ->excludes(jobs);
    verb.add_option("--lease-s", carrier.lease_s,
                    "--nats: wall seconds after which an episode whose simulated time stands still "
                    "is given to another worker (default 30)")
        ->check(CLI::Range(1.0, 3600.0));
    verb.add_option("--http", carrier.http_port, "port of the run's page, 0 = any (default: no page)")
        ->check(CLI::Range(0, 65535));
    verb.add_option("--listen", carrier.listen, "address of the page (default 127.0.0.1)");
}

/// Tries until there is a server, or the user wants to stop; then none.
template <class Made, class... Arguments>
std::unique_ptr<Made> wait_for_nats(backend::Wakeups& wakeups, const Arguments&... arguments) {
    for (bool told = false; !wakeups.stop_wanted();) {
        try {
            return std::make_unique<Made>(arguments...);
        } catch (const backend::NatsError& error) {
            if (!told) spdlog::warn("waiting for nats-server: {}", error.what());
            told = true;
        }
        wakeups.wait(episode::Clock::now() + kNatsAgain);
    }
    return nullptr;
}

std::unique_ptr<backend::Backend> make_backend(const Run& run, const Carrier& carrier,
                                               backend::Wakeups& wakeups) {
    if (carrier.nats.empty()) {
        return std::make_unique<backend::LocalBackend>(carrier.jobs, run.folder() + "/logs");
    }
    const std::chrono::milliseconds lease(static_cast<long>(carrier.lease_s * 1000.0));
    return wait_for_nats<backend::NatsBackend>(wakeups, carrier.nats, run.id(), lease);
}

int go_on(Run run, const Carrier& carrier) {
    report::RunProgress progress(std::cout, ::isatty(STDOUT_FILENO) == 1);
    progress.say(fmt::format("run {} in {}", run.name(), run.folder()));
    backend::Wakeups wakeups;  // before any thread: all of them leave the signals to it
    Watch watch(run, progress);
    if (carrier.http_port >= 0) {
        watch.serve(carrier.listen, static_cast<std::uint16_t>(carrier.http_port));
    }
    const auto backend = make_backend(run, carrier, wakeups);
    const Ended ended = backend ? optimise(run, *backend, wakeups, watch) : Ended::Stopped;
    progress.say(progress.summary() + "; " + progress.overhead());
    if (ended == Ended::Stopped) {
        progress.say("stopped; go on with: k3d-optimizer resume " + run.folder());
        return config::kExitInterrupted;
    }
    std::cout << report::course(run.ledger(), run.ended());
    progress.say("report: " + report::write_report({run.ledger(), run.experiment(),
                                                    run.algorithm().champion(), run.ended()},
                                                   run.folder() + "/report"));
    return 0;
}

/// What `show` prints beside the course of the run.
struct Look {
    std::string folder;
    bool csv = false;
    bool canonical = false;
    bool state = false;
};

int show(const Look& look) {
    const std::string& folder = look.folder;
    const auto ledger = ledger::Ledger::open(ledger_file(folder), ledger::Ledger::Access::Read);
    if (look.csv || look.canonical) {
        std::cout << report::csv(ledger.rows(), look.canonical);
        return 0;
    }
    if (look.state) {
        const auto round = ledger.last_round();
        if (!round) throw std::runtime_error(folder + " has closed no generation yet");
        std::cout << round->state << '\n';
        return 0;
    }
    const auto algorithm = algorithm_in(ledger, folder);
    std::cout << report::course(ledger, algorithm ? algorithm->finished() : std::nullopt);
    return 0;
}

int best(const std::string& folder) {
    const auto ledger = ledger::Ledger::open(ledger_file(folder), ledger::Ledger::Access::Read);
    const auto algorithm = algorithm_in(ledger, folder);
    const auto champion = algorithm ? algorithm->champion() : std::nullopt;
    if (!champion) throw std::runtime_error(folder + " has no champion yet");
    const spec::Experiment experiment = experiment_of(ledger.facts());
    std::cout << report::champion_file(experiment, *champion,
                                       report::provenance_of(*champion, experiment, ledger));
    return 0;
}

int write_report(const std::string& folder) {
    const auto ledger = ledger::Ledger::open(ledger_file(folder), ledger::Ledger::Access::Read);
    const spec::Experiment experiment = experiment_of(ledger.facts());
    report::RunFacts run{ledger, experiment, {}, {}};
    if (const auto algorithm = algorithm_in(ledger, folder)) {
        run.champion = algorithm->champion();
        run.ended = algorithm->finished();
    }
    std::cout << report::write_report(run, folder + "/report") << '\n';
    return 0;
}

/// What reports and champions say of how to make them again. Without the carrier: no result depends on
/// it, and a URL may have a password in it.
std::string command_of(const std::string& experiment, const spec::Overrides& overrides) {
    std::string command = "k3d-optimizer run " + experiment;
    for (const std::string& text : overrides) command += " --set " + spec::quote_word(text);
    return command;
}

void add_run(CLI::App& app, std::function<int()>& chosen) {
    struct Flags {
        std::string spec, folder;
        spec::Overrides overrides;
        Carrier carrier;
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = app.add_subcommand("run", "begins a run of an experiment");
    verb->add_option("SPEC", flags->spec, "the experiment, a TOML file")->required();
    verb->add_option("--run", flags->folder, "folder of the run (default runs/NAME)");
    verb->add_option("--set", flags->overrides,
                     "path=value, stronger than the experiment's file, e.g. "
                     "algorithm.max_generations=2; may be repeated")
        ->allow_extra_args(false);
    add_carrier_flags(*verb, flags->carrier);
    verb->callback([flags, &chosen] {
        chosen = [flags] {
            const std::string command = command_of(flags->spec, flags->overrides);
            return go_on(Run::begin(flags->spec, flags->overrides, flags->folder, command),
                         flags->carrier);
        };
    });
}

void add_resume(CLI::App& app, std::function<int()>& chosen) {
    struct Flags {
        std::string folder;
        Carrier carrier;
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = app.add_subcommand("resume", "goes on with a run; no episode is repeated");
    verb->add_option("RUN", flags->folder, "folder of the run")->required();
    add_carrier_flags(*verb, flags->carrier);
    verb->callback([flags, &chosen] {
        chosen = [flags] { return go_on(Run::resume(flags->folder), flags->carrier); };
    });
}

void add_looks(CLI::App& app, std::function<int()>& chosen) {
    auto look = std::make_shared<Look>();
    CLI::App* verb = app.add_subcommand("show", "tells how far a run has come");
    verb->add_option("RUN", look->folder, "folder of the run")->required();
    verb->add_flag("--csv", look->csv, "every episode as a line of CSV");
    verb->add_flag("--canonical", look->canonical,
                   "the same, only columns that follow from experiment and seed");
    verb->add_flag("--state", look->state, "the algorithm's state: its population, as JSON");
    verb->callback([look, &chosen] { chosen = [look] { return show(*look); }; });
    verb = app.add_subcommand("best", "prints the champion as k3d-agent takes it: TOML or network");
    verb->add_option("RUN", look->folder, "folder of the run")->required();
    verb->callback([look, &chosen] { chosen = [look] { return best(look->folder); }; });
    verb = app.add_subcommand("report", "writes RUN/report/report.html and tables; also at a run's end");
    verb->add_option("RUN", look->folder, "folder of the run")->required();
    verb->callback([look, &chosen] { chosen = [look] { return write_report(look->folder); }; });
}

void add_worker(CLI::App& app, std::function<int()>& chosen) {
    auto options = std::make_shared<backend::WorkerOptions>();
    CLI::App* verb = app.add_subcommand("worker", "plays the episodes of runs with --nats");
    verb->add_option("--nats", options->url, "nats-server (default nats://127.0.0.1:4222)");
    verb->add_option("--jobs", options->jobs, "episodes at a time (default 1)")
        ->check(CLI::Range(1, 256));
    verb->add_option("--log-folder", options->log_folder,
                     "logs of failed tries (default: a temporary folder)");
    verb->add_option("--idle-s", options->idle_s,
                     "ends after so many seconds without work (default: never)")
        ->check(CLI::Range(0.0, 1e6));
    verb->callback([options, &chosen] {
        chosen = [options] {
            backend::Wakeups wakeups;
            if (const auto worker = wait_for_nats<backend::Worker>(wakeups, *options)) {
                spdlog::info("at work for {}", options->url);
                worker->work(wakeups);
            }
            return 0;
        };
    });
}

}  // namespace

void add_run_verbs(CLI::App& app, std::function<int()>& chosen) {
    add_run(app, chosen);
    add_resume(app, chosen);
    add_looks(app, chosen);
    add_worker(app, chosen);
}

}  // namespace k3d::optimizer
