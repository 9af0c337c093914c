// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/reproduce.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "common/config/command_line.h"
#include "common/config/config.h"
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
    // One for all searches and rows: a wish to stop between two of them is not lost.
    backend::Wakeups wakeups;

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

std::vector<std::string> parts_for(const std::string& wanted) {
    if (wanted == "all") return spec::kParts;
    return {wanted};
}

/// Transfer tries what table 1 has learned, so it needs the champion's search.
bool is_needed(const Work& work, const spec::Search& search) {
    const bool transfers = work.wants("transfer") && work.budget.champion.empty();
    return work.wants(search.part) || (transfers && search.name == work.budget.champion_search);
}

std::string file_of(const Work& work, const spec::Search& search) {
    return fmt::format("{}/{}.toml", work.flags.experiments, search.name);
}

spec::Overrides overrides_of(const Work& work, const spec::Search& search, int number) {
    // The champion is tested in the tables, beside everything else, and not in its own run.
    spec::Overrides overrides{"test.episodes=0"};
    for (const std::string& word : spec::split_words(work.budget.searches.at(search.name).set)) {
        overrides.push_back(word);
    }
    overrides.push_back(fmt::format("seed={}", number));
    return overrides;
}

/// False if the user wants to stop.
bool learn(Work& work, const spec::Search& search, int number) {
    const std::string folder = work.search_folder(search.name, number);
    const std::string file = file_of(work, search);
    const spec::Overrides overrides = overrides_of(work, search, number);
    const bool begun = fs::exists(ledger_file(folder));
    if (begun && found_in(folder).finished) return true;
    const std::string command = fmt::format("k3d-optimizer reproduce {} --budget {}",
                                            work.flags.part, work.flags.budget);
    Run run = begun ? Run::resume(folder) : Run::begin(file, overrides, folder, command);
    work.progress.begin(fmt::format("{}, run {}: {}", search.label, number, folder));
    backend::LocalBackend backend(work.flags.jobs, folder + "/logs");
    Watch watch(run, work.progress);
    if (optimise(run, backend, work.wakeups, watch) == Ended::Stopped) return false;
    if (!run.algorithm().champion()) {
        throw std::runtime_error(folder + ": the search has ended without a champion");
    }
    run.ledger().set_fact("searched", "yes");
    report::write_report({run.ledger(), run.experiment(), run.algorithm().champion(), run.ended()},
                         folder + "/report");
    return true;
}

/// What the best run of the budget's champion_search has found, by validation; never judged by a test.
Found find_champion(const Work& work) {
    const std::string& name = work.budget.champion_search;
    std::optional<Found> best;
    for (int run = 1; run <= work.budget.searches.at(name).runs; ++run) {
        Found found = found_in(work.search_folder(name, run));
        if (!best || found.champion->score.mean > best->champion->score.mean) best = std::move(found);
    }
    return best.value();  // check_rows() has seen to it
}

/// A network's file, and what it says of itself: found files say which candidate of which run they are.
std::string named(const std::string& file) {
    const std::string description = network::load_file(file).description;
    return description.empty() ? file : fmt::format("{}: {}", file, description);
}

/// A configuration's file, and the comment it begins with: found files say there who they are.
std::string headed(const std::string& file) {
    std::ifstream in(file);
    std::string head;
    std::getline(in, head);
    return head.starts_with("# ") ? fmt::format("{}: {}", file, head.substr(2)) : file;
}

RowPlayer player_of(const Work& work, const spec::RowSpec& row) {
    if (row.takes_best) {
        RowPlayer player{find_champion(work), ""};
        player.who = player.found->origin;
        return player;
    }
    if (!row.network.empty()) return {std::nullopt, named(row.network)};
    if (!row.settings_file.empty()) return {std::nullopt, headed(row.settings_file)};
    if (row.search.empty()) return {std::nullopt, row.settings.empty() ? "defaults" : row.settings};
    RowPlayer player{found_in(work.search_folder(row.search, row.run)), ""};
    player.who = player.found->origin;
    return player;
}

bool play(Work& work, const spec::TableSpec& table) {
    for (const spec::RowSpec& row : table.rows) {
        if (!play_row(table, row, player_of(work, row), work.row_folder(table, row),
                      work.flags.jobs, work.wakeups, work.progress)) {
            return false;
        }
    }
    return true;
}

report::SearchReport read_report(const Work& work, const spec::Search& search, int run) {
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

/// A run of long ago may name parameters that the agent has no longer: that must cost no other results.
report::SearchReport report_of(const Work& work, const spec::Search& search, int run) {
    try {
        return read_report(work, search, run);
    } catch (const std::exception& error) {
        report::SearchReport report;
        report.search = search;
        report.run = run;
        report.fault = error.what();
        return report;
    }
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
            auto rows = read_rows(
                table, [&](const spec::RowSpec& row) { return work.row_folder(table, row); });
            if (rows.empty()) continue;
            const bool printed = part == "table1";
            out.tables.push_back(
                report::compare(table, std::move(rows),
                                printed ? spec::paper_table1() : std::vector<spec::PaperRow>()));
        }
    }
    return out;
}

/// A mistake in the last search must not be found when the others have taken hours.
void check_searches(const Work& work) {
    for (const auto& [search, run] : spec::runs_in_order(work.budget)) {
        if (!is_needed(work, *search)) continue;
        const std::string folder = work.search_folder(search->name, run);
        const std::string file = file_of(work, *search);
        const spec::Overrides overrides = overrides_of(work, *search, run);
        if (fs::exists(ledger_file(folder))) {
            Run::require(folder, file, overrides);
        } else {
            Run::check(file, overrides);
        }
    }
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

/// Throws network::NetworkError if the file is damaged, or of other inputs or outputs than the model.
void require_like(const std::string& file, const network::Definition& model) {
    const network::Network network(network::load_file(file), file);
    std::vector<std::string_view> inputs;
    for (const network::Input& input : model.inputs) inputs.push_back(input.name);
    const std::vector<std::string_view> outputs(model.outputs.begin(), model.outputs.end());
    network::require_shape(network, inputs, outputs, file);
}

/// The same of one that keepers take: for K1's targets, or for K3's places too.
void require_keepers_network(const std::string& file, const spec::StartNetworks& start) {
    const network::Definition both = network::load_file(start.both);
    const bool values_places = network::load_file(file).outputs.size() == both.outputs.size();
    require_like(file, values_places ? both : network::load_file(start.targets));
}

void require_found(const spec::Budget& budget) {
    for (const spec::Search& search : spec::searches()) {
        for (const std::string& file : spec::found_files(budget.searches.at(search.name))) {
            if (search.network_path.empty()) {
                config::assignments_of_file(file);
            } else if (search.part == "table1") {
                require_keepers_network(file, budget.start);
            } else {
                require_like(file, network::load_file(budget.start.possession));
            }
        }
    }
}

/// Before anything is learned: throws network::NetworkError or ConfigError if a file that is to
/// play is missing or damaged, ConfigError if settings are refused or rows want a champion that the
/// budget does not search.
void check_rows(const spec::Budget& budget, const std::vector<std::string>& parts) {
    if (!budget.champion.empty()) require_keepers_network(budget.champion, budget.start);
    require_found(budget);
    const spec::SearchBudget& search = budget.searches.at(budget.champion_search);
    const bool searched = search.runs > 0 && spec::found_files(search).empty();
    for (const std::string& part : parts) {
        for (const spec::TableSpec& table : spec::tables_of(part, budget)) {
            check_settings(table);
            for (const spec::RowSpec& row : table.rows) {
                if (!row.network.empty()) network::load_file(row.network);
                if (!row.takes_best || searched) continue;
                throw config::ConfigError(
                    fmt::format("{} wants the champion of {}, {}: name a file as champion", table.name,
                                budget.champion_search,
                                search.found.empty() ? "of which the budget has no run"
                                                     : "of which files do not tell the best"));
            }
        }
    }
}

spec::Budget budget_of(const Flags& flags) {
    const bool is_file = flags.budget.ends_with(".toml");
    spec::Budget budget = spec::load_budget(
        is_file ? flags.budget
                : fmt::format("{}/reproduce/{}.toml", flags.experiments, flags.budget));
    if (!flags.champion.empty()) budget.champion = flags.champion;
    if (!flags.foreign_takers.empty()) {
        spec::check_command("--foreign-takers", flags.foreign_takers);
        budget.foreign_takers = flags.foreign_takers;
    }
    const std::string networks = flags.experiments + "/networks/";
    budget.start = {networks + "evaluation_linear.json", networks + "open_linear.json",
                    networks + "getopen_linear.json", networks + "possession_linear.json"};
    check_rows(budget, parts_for(flags.part));
    return budget;
}

/// What the tables lack, if anything: episodes that gave no valid result in any try, and rows that
/// cannot be read.
std::string lacks(const report::Reproduction& reproduction) {
    int failed = 0;
    std::ptrdiff_t unreadable = 0;
    for (const report::Comparison& table : reproduction.tables) {
        for (const report::Circumstances& row : table.circumstances) failed += row.failed;
        unreadable += std::count_if(table.rows.begin(), table.rows.end(), is_unreadable);
    }
    std::string text;
    if (failed > 0) text = fmt::format("{} test episodes have no valid result", failed);
    if (unreadable > 0) {
        text += fmt::format("{}{} rows cannot be read", text.empty() ? "" : ", ", unreadable);
    }
    return text;
}

/// After an error, which nothing that this meets may replace: on a full disk it fails too.
void tell_what_there_is(const Work& work) {
    try {
        const std::string page = report::write_reproduction(gather(work), work.flags.out);
        work.progress.say("what there is: " + page);
    } catch (const std::exception& error) {
        work.progress.say(std::string("no report of what there is: ") + error.what());
    }
}

int reproduce(Flags flags) {
    if (flags.out.empty()) {
        flags.out = "runs/reproduce-" + fs::path(flags.budget).stem().string();
    }
    report::RunProgress progress(std::cout, ::isatty(STDOUT_FILENO) == 1);
    Work work{flags, budget_of(flags), parts_for(flags.part), progress, {}};
    check_searches(work);
    fs::create_directories(flags.out);
    bool done = false;
    try {
        done = do_parts(work);
    } catch (const std::exception&) {
        tell_what_there_is(work);
        throw;
    }
    progress.say(progress.summary());
    const report::Reproduction reproduction = gather(work);
    const std::string page = report::write_reproduction(reproduction, flags.out);
    if (!done) {
        progress.say("stopped; the same command goes on. What there is: " + page);
        return config::kExitInterrupted;
    }
    std::cout << report::reproduction_text(reproduction);
    progress.say("report: " + page);
    const std::string lacking = lacks(reproduction);
    if (!lacking.empty()) progress.say(lacking);
    return lacking.empty() ? 0 : 1;
}

}  // namespace

void add_reproduce_verb(CLI::App& app, std::function<int()>& chosen) {
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = app.add_subcommand(
        "reproduce", "learns and measures what the paper reports, and writes its tables and figures");
    std::vector<std::string> parts = spec::kParts;
    parts.push_back("all");
    verb->add_option("PART", flags->part, "what of it (default all)")->check(CLI::IsMember(parts));
    verb->add_option("--budget", flags->budget,
                     "small, paper, large, published, or a TOML file (default small)");
    verb->add_option("--out", flags->out, "folder (default runs/reproduce-BUDGET)");
    verb->add_option(
        "--champion", flags->champion,
        "network file learned before: plays table 1 too, and in the champion's place against "
        "slow or foreign takers and in transfer");
    verb->add_option("--foreign-takers", flags->foreign_takers,
                     "command of a foreign program: table 1 also against it in the takers' seats");
    verb->add_option("--experiments", flags->experiments,
                     "folder of the experiments (default optimizer/experiments)");
    verb->add_option("--jobs", flags->jobs, "episodes at a time (default 1)")
        ->check(CLI::Range(1, 256));
    verb->callback([flags, &chosen] { chosen = [flags] { return reproduce(*flags); }; });
}

}  // namespace k3d::optimizer
