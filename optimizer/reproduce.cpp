// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/reproduce.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "common/network/network.h"
#include "common/version/version.h"
#include "optimizer/backend/local_backend.h"
#include "optimizer/daemon.h"
#include "optimizer/fitness/fitness.h"
#include "optimizer/report/reproduction_page.h"
#include "optimizer/report/run_report.h"
#include "optimizer/run.h"
#include "optimizer/spec/match_spec.h"
#include "optimizer/spec/words.h"
#include "optimizer/test_table.h"

namespace k3d::optimizer {

namespace fs = std::filesystem;

namespace {

constexpr int kExitInterrupted = 130;

struct Flags {
    std::string part = "all";
    std::string budget = "small";
    std::string experiments = "optimizer/experiments";
    std::string out;
    std::string champion;
    std::string foreign_takers;
    int jobs = 1;
};

/// What has to be known everywhere below.
struct Work {
    Flags flags;
    spec::Budget budget;
    std::vector<std::string> parts;
    report::RunProgress& progress;

    bool wants(const std::string& part) const {
        return std::find(parts.begin(), parts.end(), part) != parts.end();
    }
    std::string search_folder(const std::string& name, int run) const {
        return fmt::format("{}/search/{}-{}", flags.out, name, run);
    }
    std::string row_folder(const spec::TableSpec& table, const spec::RowSpec& row) const {
        return fmt::format("{}/test/{}/{}", flags.out, table.name, row.key);
    }
};

/// Transfer tries what table 1 has learned, so it needs those searches.
std::vector<std::string> parts_for(const std::string& wanted) {
    if (wanted == "all") return spec::kParts;
    return {wanted};
}

bool is_needed(const Work& work, const spec::Search& search) {
    const bool transfers = work.wants("transfer") && work.budget.champion.empty();
    return work.wants(search.part) || (search.part == "table1" && transfers);
}

Run open_run(const Work& work, const spec::Search& search, int number, const std::string& folder) {
    if (fs::exists(ledger_file(folder))) return Run::resume(folder);
    const std::string file = fmt::format("{}/{}.toml", work.flags.experiments, search.name);
    // The champion is tested in the tables, beside everything else, and not in its own run.
    spec::Overrides overrides{"test.episodes=0"};
    for (const std::string& word : spec::split_words(work.budget.searches.at(search.name).set)) {
        overrides.push_back(word);
    }
    overrides.push_back(fmt::format("seed={}", number));
    return Run::begin(file, overrides, folder,
                      fmt::format("k3d-optimizer reproduce {} --budget {}", work.flags.part,
                                  work.flags.budget));
}

/// False if the user wants to stop.
bool learn(Work& work, const spec::Search& search, int number) {
    const std::string folder = work.search_folder(search.name, number);
    if (fs::exists(ledger_file(folder)) && found_in(folder).finished) return true;
    Run run = open_run(work, search, number, folder);
    work.progress.say(fmt::format("{}, run {}: {}", search.label, number, folder));
    backend::Wakeups wakeups;  // before any thread: all of them leave the signals to it
    backend::LocalBackend backend(work.flags.jobs, folder + "/logs");
    Watch watch(run, work.progress);
    if (optimise(run, backend, wakeups, watch) == Ended::Stopped) return false;
    if (!run.algorithm().champion()) {
        throw std::runtime_error(folder + ": the search has ended without a champion");
    }
    run.ledger().set_fact("searched", "yes");
    report::write_report({run.ledger(), run.experiment(), run.algorithm().champion(), run.ended()},
                         folder + "/report");
    return true;
}

/// The learned evaluation function of the best validated passes; never judged by a test.
Found best_of_table1(const Work& work) {
    std::optional<Found> best;
    for (const spec::Search& search : spec::searches()) {
        if (search.part != "table1") continue;
        for (int run = 1; run <= work.budget.searches.at(search.name).runs; ++run) {
            Found found = found_in(work.search_folder(search.name, run));
            if (found.experiment.network.path != "keeper.policy") continue;
            if (fitness::measure(found.experiment.task) != "attempts") continue;
            if (!best || found.champion->score.mean > best->champion->score.mean) {
                best = std::move(found);
            }
        }
    }
    if (!best) throw std::runtime_error("the budget has no search that learns an evaluation function");
    return *best;
}

RowPlayer player_of(const Work& work, const spec::RowSpec& row) {
    if (row.takes_best) {
        RowPlayer player{best_of_table1(work), ""};
        player.who = player.found->origin;
        return player;
    }
    if (row.search.empty()) return {std::nullopt, row.settings.empty() ? "defaults" : row.settings};
    RowPlayer player{found_in(work.search_folder(row.search, row.run)), ""};
    player.who = player.found->origin;
    return player;
}

bool play(Work& work, const spec::TableSpec& table) {
    backend::Wakeups wakeups;
    for (const spec::RowSpec& row : table.rows) {
        if (!play_row(table, row, player_of(work, row), work.row_folder(table, row),
                      work.flags.jobs, wakeups, work.progress)) {
            return false;
        }
    }
    return true;
}

report::SearchReport report_of(const Work& work, const spec::Search& search, int run) {
    const std::string folder = work.search_folder(search.name, run);
    const Found found = found_in(folder);
    const auto ledger = ledger::Ledger::open(ledger_file(folder), ledger::Ledger::Access::Read);
    return {search,
            run,
            found.experiment.algorithm.name,
            fitness::measure(found.experiment.task),
            found.origin,
            found.version,
            found.generations,
            found.finished,
            ledger.totals(),
            report::curves_of(ledger, report::value_names(found.experiment))};
}

/// All that is there, also of parts that an earlier command has made.
report::Reproduction gather(const Work& work) {
    report::Reproduction out;
    out.budget = work.flags.budget;
    out.description = work.budget.description;
    out.version = std::string(code_version());
    for (const spec::Search& search : spec::searches()) {
        for (int run = 1; run <= work.budget.searches.at(search.name).runs; ++run) {
            if (!fs::exists(ledger_file(work.search_folder(search.name, run)))) continue;
            out.searches.push_back(report_of(work, search, run));
        }
    }
    for (const std::string& part : spec::kParts) {
        for (const spec::TableSpec& table : spec::tables_of(part, work.budget)) {
            report::Comparison comparison{table, {}, {}};
            if (part == "table1") comparison.paper = spec::paper_table1();
            for (const spec::RowSpec& row : table.rows) {
                auto played = read_row(row, work.row_folder(table, row));
                if (!played.rows.empty()) comparison.rows.push_back(std::move(played));
            }
            if (!comparison.rows.empty()) out.tables.push_back(std::move(comparison));
        }
    }
    return out;
}

/// All searches that are needed, then each part's tables; false if the user wants to stop.
bool do_parts(Work& work) {
    for (const auto& [search, run] : spec::runs_in_order(work.budget)) {
        if (is_needed(work, *search) && !learn(work, *search, run)) return false;
    }
    for (const std::string& part : work.parts) {
        for (const spec::TableSpec& table : spec::tables_of(part, work.budget)) {
            if (!play(work, table)) return false;
        }
    }
    return true;
}

int reproduce(Flags flags) {
    const bool is_file = flags.budget.ends_with(".toml");
    const std::string file =
        is_file ? flags.budget : fmt::format("{}/reproduce/{}.toml", flags.experiments, flags.budget);
    if (flags.out.empty()) {
        flags.out = "runs/reproduce-" + fs::path(flags.budget).stem().string();
    }
    report::RunProgress progress(std::cout, ::isatty(STDOUT_FILENO) == 1);
    Work work{flags, spec::load_budget(file), parts_for(flags.part), progress};
    if (!flags.champion.empty()) {
        network::load_file(flags.champion);  // to learn of its faults before anything is played
        work.budget.champion = fs::absolute(flags.champion).lexically_normal().string();
    }
    if (!flags.foreign_takers.empty()) {
        spec::check_command("--foreign-takers", flags.foreign_takers);
        work.budget.foreign_takers = flags.foreign_takers;
    }
    // Agents start in other folders.
    work.budget.start = fs::absolute(flags.experiments + "/networks/evaluation_linear.json")
                            .lexically_normal()
                            .string();
    fs::create_directories(flags.out);
    const bool done = do_parts(work);
    progress.say(progress.summary());
    const report::Reproduction reproduction = gather(work);
    const std::string page = report::write_reproduction(reproduction, flags.out);
    if (!done) {
        progress.say("stopped; the same command goes on. What there is: " + page);
        return kExitInterrupted;
    }
    std::cout << report::reproduction_text(reproduction);
    progress.say("report: " + page);
    return 0;
}

}  // namespace

void add_reproduce_verb(CLI::App& app, std::function<int()>& chosen) {
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = app.add_subcommand(
        "reproduce", "learns and measures what the paper reports, and writes its tables and figures");
    std::vector<std::string> parts = spec::kParts;
    parts.push_back("all");
    verb->add_option("PART", flags->part, "what of it (default all)")->check(CLI::IsMember(parts));
    verb->add_option("--budget", flags->budget, "small, paper, large, or a TOML file (default small)");
    verb->add_option("--out", flags->out, "folder (default runs/reproduce-BUDGET)");
    verb->add_option("--champion", flags->champion,
                     "network file learned before: plays table 1 too, and transfer");
    verb->add_option("--foreign-takers", flags->foreign_takers,
                     "command of a foreign program: table 1 also against it in the takers' seats");
    verb->add_option("--experiments", flags->experiments,
                     "folder of the experiments (default optimizer/experiments)");
    verb->add_option("--jobs", flags->jobs, "episodes at a time (default 1)")
        ->check(CLI::Range(1, 256));
    verb->callback([flags, &chosen] { chosen = [flags] { return reproduce(*flags); }; });
}

}  // namespace k3d::optimizer
