// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/spec/reproduction.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "common/config/config.h"
#include "optimizer/spec/match_spec.h"
#include "optimizer/spec/settings.h"
#include "optimizer/spec/words.h"

namespace k3d::optimizer::spec {

namespace {

constexpr const char* kReference = "algorithm2";
constexpr const char* kPolicy = "keeper.policy";

/// The first of `found` play as files, the others from their runs.
std::vector<RowSpec> rows_of(const Search& search, int runs, const std::vector<std::string>& found) {
    std::vector<RowSpec> rows;
    for (int run = 1; run <= std::max(runs, static_cast<int>(found.size())); ++run) {
        RowSpec row{.key = fmt::format("{}-{}", search.name, run),
                    .label = search.label,
                    .settings = {},
                    .search = search.name,
                    .run = run};
        if (run <= static_cast<int>(found.size())) {
            const std::string& file = found[static_cast<std::size_t>(run - 1)];
            if (search.network_path.empty()) {
                row.settings_file = file;
            } else {
                row.network = file;
                row.network_path = search.network_path;
            }
        }
        rows.push_back(row);
    }
    if (rows.size() > 1) {
        for (RowSpec& row : rows) row.label += fmt::format(", run {}", row.run);
    }
    return rows;
}

/// Rows of the runs of every search of a part, in the order of searches().
void add_learned(std::vector<RowSpec>& rows, const std::string& part, const Budget& budget) {
    for (const Search& search : searches()) {
        if (search.part != part) continue;
        const SearchBudget& spent = budget.searches.at(search.name);
        const auto more = rows_of(search, spent.runs, found_files(spent));
        rows.insert(rows.end(), more.begin(), more.end());
    }
}

RowSpec plain(std::string key, std::string label, std::string settings) {
    return {.key = std::move(key),
            .label = std::move(label),
            .settings = std::move(settings),
            .search = {}};
}

RowSpec network_file(std::string key, std::string label, const std::string& file) {
    RowSpec row = plain(std::move(key), std::move(label), "");
    row.network = file;
    return row;
}

RowSpec champion_file(const Budget& budget) {
    return network_file("champion-file", "Learned before: " + budget.champion, budget.champion);
}

RowSpec best_learned(const Budget& budget) {
    if (!budget.champion.empty()) return champion_file(budget);
    RowSpec row = plain("champion", "Learned: champion of table 1", "");
    row.takes_best = true;
    return row;
}

TableSpec keepaway_table(std::string name, std::string title, const Budget& budget) {
    TableSpec table;
    table.name = std::move(name);
    table.title = std::move(title);
    table.task.settings = budget.settings;
    table.episodes = budget.keepaway_episodes;
    table.reference = kReference;
    return table;
}

RowSpec algorithm2() {
    return plain(kReference, "Algorithm 2, constants as printed", "keeper.policy=handcoded");
}

/// What learning has to beat; how much of a gain is the start networks' own, or comes from where K3 stands,
/// show their rows.
std::vector<RowSpec> all_baselines(const StartNetworks& start) {
    RowSpec with_places = algorithm2();
    with_places.key = "algorithm2-places";
    with_places.label = "Algorithm 2, K3's places by hand";
    with_places.network = start.places;
    with_places.network_path = "keeper.open";
    return {algorithm2(),
            with_places,
            network_file("start", "Linear by hand: where the linear searches start", start.targets),
            network_file("start-places", "Linear by hand, K3's places too", start.both),
            plain("random", "Random one of the possible targets", "keeper.policy=random"),
            plain("hold", "Always hold", "keeper.policy=hold"),
            plain("still", "Stand still", "keeper.policy=still")};
}

std::vector<RowSpec> keepaway_baselines(const Budget& budget) {
    const std::vector<std::string> wanted = split_words(budget.baselines);
    std::vector<RowSpec> rows = all_baselines(budget.start);
    std::erase_if(rows, [&](const RowSpec& row) {
        return row.key != kReference &&
               std::find(wanted.begin(), wanted.end(), row.key) == wanted.end();
    });
    return rows;
}

bool has_network(const TableSpec& table, const std::string& file) {
    return std::any_of(table.rows.begin(), table.rows.end(),
                       [&](const RowSpec& row) { return row.network == file; });
}

std::vector<TableSpec> table1(const Budget& budget) {
    std::vector<TableSpec> tables;
    const auto add = [&](TableSpec table, const std::string& taker) {
        table.part = "table1";
        table.task.taker = taker;
        tables.push_back(std::move(table));
    };
    for (const std::string& taker : split_words(budget.takers)) {
        TableSpec table = keepaway_table("table1-" + taker, "Table 1, takers " + taker, budget);
        add_learned(table.rows, "table1", budget);
        if (!budget.champion.empty() && !has_network(table, budget.champion)) {
            table.rows.push_back(champion_file(budget));
        }
        const auto baselines = keepaway_baselines(budget);
        table.rows.insert(table.rows.end(), baselines.begin(), baselines.end());
        add(std::move(table), taker);
    }
    if (budget.slow_takers) {
        // Takers share our walk; the reference team's is slower, and so may the paper's have been.
        TableSpec table = keepaway_table(
            "table1-slow", "Table 1, takers greedy_random, at most 0.66 m/s", budget);
        table.task.settings += " taker:taker.top_speed=0.66";
        table.rows = {best_learned(budget), algorithm2()};
        add(std::move(table), "greedy_random");
    }
    if (!budget.foreign_takers.empty()) {
        TableSpec table = keepaway_table("table1-foreign", "Table 1, takers a foreign program", budget);
        table.task.taker_command = budget.foreign_takers;
        table.rows = {best_learned(budget), algorithm2()};
        add(std::move(table), "greedy");
    }
    return tables;
}

std::vector<TableSpec> transfer(const Budget& budget) {
    std::vector<TableSpec> tables;
    const auto add = [&](const std::string& name, const std::string& title, int keepers, int takers,
                         const std::string& settings) {
        TableSpec table = keepaway_table("transfer-" + name, title, budget);
        table.part = "transfer";
        table.episodes = budget.transfer_episodes;
        table.task.taker = "greedy_random";
        table.task.keepers = keepers;
        table.task.takers = takers;
        table.task.settings += settings;
        table.rows = {best_learned(budget), algorithm2()};
        tables.push_back(std::move(table));
    };
    add("4v3", "4 keepers against 3 takers, champion of 3 against 2", 4, 3, "");
    add("5v4", "5 keepers against 4 takers, champion of 3 against 2", 5, 4, "");
    for (const std::string& side : split_words(budget.sides)) {
        add(side + "m", fmt::format("Area of {0} x {0} m, champion of 10 x 10 m", side), 3, 2,
            fmt::format(" server:keepaway.side={0} agent:keepaway.side={0}", side));
    }
    return tables;
}

TableSpec possession(const Budget& budget) {
    TableSpec table;
    table.name = table.part = "possession";
    table.title = "Getting possession: time to the kick on the twelve test scenarios";
    table.task.name = "possession";
    table.task.worst = -30.0;
    table.episodes = budget.possession_episodes;
    table.reference = "rules";
    add_learned(table.rows, "possession", budget);
    table.rows.push_back(plain("rules", "Hand-coded state machine", "possession.chooser=rules"));
    table.rows.push_back(plain("straight", "Straight to the ball", "possession.chooser=straight"));
    table.rows.push_back(plain("random", "Random state", "possession.chooser=random"));
    return table;
}

void check_taker(const std::string& taker) {
    if (taker == "greedy" || taker == "greedy_random") return;
    throw std::invalid_argument(fmt::format("takers: '{}' is not greedy or greedy_random", taker));
}

void check_baseline(const std::string& key) {
    std::string all;
    for (const RowSpec& row : all_baselines({})) {
        if (row.key == key) return;
        all += " " + row.key;
    }
    throw std::invalid_argument(fmt::format("baselines: '{}' is none of:{}", key, all));
}

void check_side(const std::string& side) {
    double value = 0.0;
    const auto read = std::from_chars(side.data(), side.data() + side.size(), value);
    const bool whole = read.ec == std::errc() && read.ptr == side.data() + side.size();
    if (whole && value >= 8.0 && value <= 14.0) return;
    throw std::invalid_argument(fmt::format("sides: '{}' is not a number from 8 to 14", side));
}

void check_words(const std::string& key, const std::string& text) {
    try {
        split_words(text);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(fmt::format("{}: \"{}\": {}", key, text, error.what()));
    }
}

/// Champions of different searches met other takers and time limits: their scores cannot be compared.
void check_champion(const Budget& budget) {
    const std::string& name = budget.champion_search;
    const auto is_it = [&](const Search& s) { return s.part == "table1" && s.name == name; };
    if (std::none_of(searches().begin(), searches().end(), is_it)) {
        throw std::invalid_argument(
            fmt::format("champion_search: '{}' is no search of table1", name));
    }
}

TableSpec drill_table(const std::string& part, const Budget& budget) {
    const bool kick = part == "fig2";
    TableSpec table;
    table.name = table.part = part;
    table.title = kick ? "Kick by equation (1) on the twelve test scenarios"
                       : "Prediction of where a rolling ball stops";
    table.task.name = kick ? "kick" : "ball_prediction";
    table.task.worst = kick ? -1.0 : -25.0;
    table.episodes = kick ? budget.kick_episodes : budget.rolls;
    table.reference = "untuned";
    add_learned(table.rows, part, budget);
    table.rows.push_back(plain("untuned", "The agent's own settings", ""));
    return table;
}

}  // namespace

const std::vector<Search>& searches() {
    static const std::vector<Search> list{
        {"kick", "fig2", "Kick by CMA-ES"},
        {"ball_prediction", "fig3", "Prediction by CMA-ES"},
        {"possession_neat", "possession", "Network by NEAT", "possession.network"},
        {"possession_linear", "possession", "Linear network by CMA-ES", "possession.network"},
        {"keepaway_linear", "table1", "Learned: linear by CMA-ES", kPolicy},
        {"keepaway_neat_noise", "table1", "Learned: NEAT with noise handling", kPolicy},
        {"keepaway_neat", "table1", "Learned: NEAT as in the paper", kPolicy},
        {"keepaway_linear_both", "table1", "Learned: linear by CMA-ES, against takers of both kinds", kPolicy},
        {"keepaway_linear_hold", "table1", "Learned: linear by CMA-ES, hold time as fitness", kPolicy},
        {"keepaway_linear_getopen", "table1", "Learned: linear by CMA-ES, K3's places too", kPolicy},
        {"keepaway_algorithm2", "table1", "Algorithm 2, constants by CMA-ES"}};
    return list;
}

std::vector<std::string> found_files(const SearchBudget& search) {
    return split_words(search.found);
}

Budget::Budget() {
    for (const Search& search : spec::searches()) searches[search.name];
}

void Budget::describe(config::Fields& f) {
    f.text("description", description, {}, "what it is for");
    f.integer("keepaway_episodes", keepaway_episodes, {2, 100000}, "", "test episodes of a row of table 1");
    f.integer("possession_episodes", possession_episodes, {2, 100000}, "", "of possession");
    f.integer("transfer_episodes", transfer_episodes, {2, 100000}, "", "of transfer");
    f.integer("kick_episodes", kick_episodes, {2, 100000}, "", "of fig2");
    f.integer("rolls", rolls, {2, 100000}, "", "balls of fig3");
    f.text("takers", takers, {}, "words greedy, greedy_random: a table 1 against each");
    f.text("baselines", baselines, {},
           "words: rows of table 1 beside what is learned and Algorithm 2, as tables.csv names them");
    f.text("sides", sides, {}, "words: other sides of the area, m, that transfer tries");
    f.text("settings", settings, {}, "words PROGRAM:path=value in all keepaway test episodes");
    f.text("champion", champion, {},
           "network file: a row of table 1, and plays transfer instead of what was found");
    f.text("champion_search", champion_search, {},
           "without such a file: the search whose best run, by validation, plays transfer and the like");
    f.boolean("slow_takers", slow_takers, "table 1 also against takers of 0.66 m/s");
    f.text("foreign_takers", foreign_takers, {},
           "command of a foreign program: table 1 also against it in the takers' seats");
    for (auto& [name, search] : searches) f.section(name, search);
}

Budget load_budget(const std::string& file) {
    Budget budget;
    config::load_file(config::describing(budget), file);
    try {
        parse_settings(budget.settings);
        for (const std::string& taker : split_words(budget.takers)) check_taker(taker);
        for (const std::string& key : split_words(budget.baselines)) check_baseline(key);
        check_command("foreign_takers", budget.foreign_takers);
        for (const std::string& side : split_words(budget.sides)) check_side(side);
        for (const auto& [name, search] : budget.searches) {
            check_words(name + ".set", search.set);
            check_words(name + ".found", search.found);
        }
        check_champion(budget);
    } catch (const std::invalid_argument& error) {
        throw config::ConfigError(fmt::format("{}: {}", file, error.what()));
    }
    return budget;
}

std::vector<SearchRun> runs_in_order(const Budget& budget) {
    std::vector<SearchRun> order;
    int rounds = 0;
    for (const auto& [name, search] : budget.searches) rounds = std::max(rounds, search.runs);
    for (int run = 1; run <= rounds; ++run) {
        for (const Search& search : searches()) {
            const SearchBudget& spent = budget.searches.at(search.name);
            const bool is_found = run <= static_cast<int>(found_files(spent).size());
            if (!is_found && run <= spent.runs) order.push_back({&search, run});
        }
    }
    return order;
}

std::vector<TableSpec> tables_of(const std::string& part, const Budget& budget) {
    if (part == "table1") return table1(budget);
    if (part == "transfer") return transfer(budget);
    if (part == "possession") return {possession(budget)};
    return {drill_table(part, budget)};
}

const std::vector<PaperRow>& paper_table1() {
    static const std::vector<PaperRow> rows{
        {"", "Paper: learned", 4.55, 0.129, 43.238, 1.034},
        {"algorithm2", "Paper: hand-coded", 3.1, 0.062, 31.764, 0.482}};
    return rows;
}

}  // namespace k3d::optimizer::spec
