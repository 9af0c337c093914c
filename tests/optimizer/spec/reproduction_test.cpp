// SPDX-License-Identifier: BSD-3-Clause
// What is reproduced: the budgets that are there load, every search has its experiment, every table a
// reference among its rows.
#include "optimizer/spec/reproduction.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "common/config/config.h"
#include "optimizer/algorithm/algorithm.h"
#include "optimizer/spec/experiment.h"
#include "optimizer/spec/words.h"

namespace k3d::optimizer::spec {
namespace {

const std::string kFolder = K3D_SOURCE_DIR "/optimizer/experiments";

TEST(Reproduction, EverySearchHasItsExperimentAndItsPart) {
    for (const Search& search : searches()) {
        EXPECT_TRUE(std::filesystem::exists(kFolder + "/" + search.name + ".toml")) << search.name;
        EXPECT_NE(std::find(kParts.begin(), kParts.end(), search.part), kParts.end()) << search.name;
    }
}

std::string content(const std::string& name) {
    std::ostringstream text;
    text << std::ifstream(kFolder + "/" + name).rdbuf();
    return text.str();
}

class Budgets : public testing::TestWithParam<std::string> {};

TEST_P(Budgets, GivesWholeTables) {
    const Budget budget = load_budget(kFolder + "/reproduce/" + GetParam() + ".toml");
    std::set<std::string> names;
    for (const std::string& part : kParts) {
        for (const TableSpec& table : tables_of(part, budget)) {
            EXPECT_TRUE(names.insert(table.name).second) << table.name;
            EXPECT_EQ(table.part, part);
            EXPECT_GE(table.episodes, 2);
            std::set<std::string> keys;
            for (const RowSpec& row : table.rows) EXPECT_TRUE(keys.insert(row.key).second) << row.key;
            EXPECT_TRUE(keys.contains(table.reference)) << table.name;
            EXPECT_EQ(table.task.settings.find("fast"), std::string::npos)
                << "tests are judged on the exact stepper";
        }
    }
    EXPECT_EQ(names.contains("table1-greedy"), GetParam() != "small") << "it has no time for both";
    EXPECT_TRUE(names.contains("table1-greedy_random"));
    EXPECT_TRUE(names.contains("transfer-4v3"));
}

TEST_P(Budgets, SetsWhatItsSearchesTake) {
    const Budget budget = load_budget(kFolder + "/reproduce/" + GetParam() + ".toml");
    const AgentFields fields = ask_agent_fields(K3D_BIN_DIR "/k3d-agent");
    for (const auto& [name, search] : budget.searches) {
        if (search.runs == 0) continue;
        const Experiment e = parse_experiment(content(name + ".toml"), name, fields, content,
                                              split_words(search.set));
        EXPECT_NO_THROW(algorithm::Algorithm(e.algorithm, problem_of(e), e.seed)) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(Reproduction, Budgets, testing::Values("small", "paper", "large", "published"));

TEST(Reproduction, RowsFollowTheBudget) {
    Budget budget;
    for (auto& [name, search] : budget.searches) search.runs = 0;
    budget.searches["keepaway_neat"].runs = 3;
    budget.takers = "greedy";
    budget.slow_takers = false;
    const auto tables = tables_of("table1", budget);
    ASSERT_EQ(tables.size(), 1u);
    ASSERT_EQ(tables[0].rows.size(), 3u + 7u);
    EXPECT_EQ(tables[0].rows[2].key, "keepaway_neat-3");
    EXPECT_EQ(tables[0].rows[2].run, 3);
    EXPECT_EQ(tables[0].task.taker, "greedy");
}

TEST(Reproduction, EverySearchHasItsFirstRunBeforeAnyHasItsSecond) {
    Budget budget;
    for (auto& [name, search] : budget.searches) search.runs = 0;
    budget.searches["keepaway_linear"].runs = 3;
    budget.searches["keepaway_neat"].runs = 2;
    std::vector<std::string> order;
    for (const auto& [search, run] : runs_in_order(budget)) {
        order.push_back(search->name + "-" + std::to_string(run));
    }
    EXPECT_THAT(order, testing::ElementsAre("keepaway_linear-1", "keepaway_neat-1", "keepaway_linear-2",
                                            "keepaway_neat-2", "keepaway_linear-3"));
}

TEST(Reproduction, NetworksMadeByHandPlayToo) {
    Budget budget;
    budget.start = {"/some where/targets.json", "/some where/places.json", "/some where/both.json"};
    const auto file_of = [](const TableSpec& table, const std::string& key) {
        const auto row = std::find_if(table.rows.begin(), table.rows.end(),
                                      [&](const RowSpec& r) { return r.key == key; });
        return row == table.rows.end() ? "no row" : row->network_path + "=" + row->network;
    };
    for (const TableSpec& table : tables_of("table1", budget)) {
        if (table.name == "table1-slow") continue;
        EXPECT_EQ(file_of(table, "start"), "keeper.policy=/some where/targets.json");
        EXPECT_EQ(file_of(table, "start-places"), "keeper.policy=/some where/both.json");
        EXPECT_EQ(file_of(table, "algorithm2-places"), "keeper.open=/some where/places.json");
    }
    budget.baselines = "start";
    const TableSpec table = tables_of("table1", budget).front();
    EXPECT_EQ(file_of(table, "start-places"), "no row");
    EXPECT_EQ(file_of(table, "algorithm2"), "keeper.policy=") << "the reference always plays";
}

TEST(Reproduction, AChampionLearnedBeforePlaysToo) {
    Budget budget;
    budget.champion = "/some where/net.json";
    const auto tables = tables_of("table1", budget);
    const auto is_champion = [](const RowSpec& row) {
        return row.key == "champion-file" && row.network == "/some where/net.json";
    };
    for (const TableSpec& table : tables) {
        EXPECT_TRUE(std::any_of(table.rows.begin(), table.rows.end(), is_champion)) << table.name;
    }
    EXPECT_FALSE(tables_of("transfer", budget).front().rows.front().takes_best);
}

TEST(Reproduction, FoundNetworksTakeThePlaceOfTheFirstRuns) {
    Budget budget;
    for (auto& [name, search] : budget.searches) search.runs = 0;
    budget.searches["keepaway_linear"] = {.runs = 3, .set = {}, .found = "one.json 'a second.json'"};
    budget.searches["possession_neat"].found = "three.json";
    const auto order = runs_in_order(budget);
    ASSERT_EQ(order.size(), 1u);
    EXPECT_EQ(order[0].run, 3);
    const auto rows = tables_of("table1", budget).front().rows;
    ASSERT_GT(rows.size(), 3u);
    EXPECT_EQ(rows[1].key, "keepaway_linear-2");
    EXPECT_EQ(rows[1].network, "a second.json");
    EXPECT_EQ(rows[1].network_path, "keeper.policy");
    EXPECT_THAT(rows[1].label, testing::HasSubstr(", run 2"));
    EXPECT_EQ(rows[2].network, "");
    EXPECT_EQ(rows[2].search, "keepaway_linear");
    const RowSpec chooser = tables_of("possession", budget).front().rows.front();
    EXPECT_EQ(chooser.network_path + "=" + chooser.network, "possession.network=three.json");
    EXPECT_EQ(chooser.label, "Network by NEAT");
    budget.searches["keepaway_algorithm2"].found = "constants.toml";
    const auto more = tables_of("table1", budget).front().rows;
    ASSERT_GT(more.size(), 3u);
    EXPECT_EQ(more[3].settings_file, "constants.toml") << "this search finds settings";
    EXPECT_EQ(more[3].network, "");
    budget.searches["keepaway_algorithm2"].found = "";

    budget.champion = "one.json";
    EXPECT_EQ(tables_of("table1", budget).front().rows.size(), rows.size()) << "it plays already";
}

TEST(Reproduction, AForeignProgramCanTakeTheTakersSeats) {
    Budget budget;
    budget.foreign_takers = "other-agent {host} {port}";
    const auto tables = tables_of("table1", budget);
    const TableSpec& table = tables.back();
    EXPECT_EQ(table.name, "table1-foreign");
    EXPECT_EQ(table.task.taker_command, budget.foreign_takers);
    EXPECT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(std::count_if(tables.begin(), tables.end(),
                            [](const TableSpec& t) { return !t.task.taker_command.empty(); }),
              1);
}

TEST(Reproduction, MistakesAreNamed) {
    const std::string file = testing::TempDir() + "/budget-" + std::to_string(getpid()) + ".toml";
    const auto fault = [&](const std::string& text) -> std::string {
        std::ofstream(file) << text;
        try {
            load_budget(file);
        } catch (const config::ConfigError& error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_THAT(fault("[keepaway_neet]\nruns = 1\n"), testing::HasSubstr("keepaway_neet"));
    EXPECT_THAT(fault("settings = \"somebody:x=1\"\n"), testing::HasSubstr("somebody:x=1"));
    EXPECT_THAT(fault("takers = \"greedy lazy\"\n"), testing::HasSubstr("lazy"));
    EXPECT_THAT(fault("foreign_takers = \"agent {prot}\"\n"), testing::HasSubstr("prot"));
    EXPECT_THAT(fault("baselines = \"start sitl\"\n"), testing::HasSubstr("sitl"));
    EXPECT_THAT(fault("champion_search = \"kick\"\n"), testing::HasSubstr("kick"));
    EXPECT_THAT(fault("[kick]\nfound = \"'kick.toml\"\n"), testing::HasSubstr("kick.found: \"'kick.toml\""));
    EXPECT_THAT(fault("[kick]\nset = \"'seed=1\"\n"), testing::HasSubstr("kick.set: "));
    EXPECT_THAT(fault("sides = \"ten\"\n"), testing::HasSubstr("ten"));
    EXPECT_EQ(fault("sides = \"10.5\"\n"), "none");
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace k3d::optimizer::spec
