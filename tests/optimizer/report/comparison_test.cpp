// SPDX-License-Identifier: BSD-3-Clause
// Tables of test episodes: pairs are made by episode, what failed is counted and in no mean, the median run
// is marked.
#include "optimizer/report/comparison.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <functional>

#include "common/episode/result.h"

namespace k3d::optimizer::report {
namespace {

using testing::HasSubstr;

ledger::Row episode_row(int episode, double hold, int attempts) {
    k3d::episode::Result r;
    r.game = "keepaway";
    r.reason = "taker_reached_ball";
    r.hold_time_s = hold;
    r.attempts = attempts;
    r.players = {{"left", 1, 1, 6.0, 0.3}, {"right", 1, 0, 12.0, 0.6}};
    r.state_hash = "00";
    r.code_version = "x";
    ledger::Row row;
    row.key = {k3d::optimizer::episode::Phase::Test, 0, 0, episode};
    row.status = "finished";
    row.reason = r.reason;
    row.result = k3d::episode::to_line(r);
    return row;
}

ledger::Row failed_row(int episode) {
    ledger::Row row;
    row.key = {k3d::optimizer::episode::Phase::Test, 0, 0, episode};
    row.status = "failed";
    row.reason = "no valid result in 4 tries";
    return row;
}

spec::RowSpec spec_of(const std::string& key, const std::string& search, int run) {
    return {.key = key, .label = "Row " + key, .settings = "", .search = search, .run = run};
}

/// What a comparison is made of.
struct Given {
    spec::TableSpec table;
    std::vector<ComparedRow> rows;
    std::vector<spec::PaperRow> paper;

    Comparison compared() const { return compare(table, rows, paper); }
};

Given three_rows() {
    Given c;
    c.table.name = "table1-greedy";
    c.table.title = "Table 1";
    c.table.reference = "algorithm2";
    c.rows = {{spec_of("a-1", "a", 1), "", {episode_row(0, 20.0, 4), episode_row(1, 30.0, 6)}},
              {spec_of("a-2", "a", 2), "", {episode_row(0, 40.0, 8), failed_row(1)}},
              {spec_of("algorithm2", "", 1), "", {episode_row(0, 10.0, 2), episode_row(1, 25.0, 3)}}};
    c.paper = spec::paper_table1();
    return c;
}

TEST(Comparison, ByEpisodeAgainstTheReference) {
    const Comparison c = three_rows().compared();
    const ComparedFigure& attempts = c.figures.at(0);
    EXPECT_EQ(attempts.name, "attempts");
    EXPECT_DOUBLE_EQ(*attempts.lines[0].s.mean, 5.0);
    ASSERT_TRUE(attempts.lines[0].against);
    EXPECT_DOUBLE_EQ(attempts.lines[0].against->difference, 2.5);
    EXPECT_DOUBLE_EQ(*attempts.lines[0].against->ratio, 2.0);
    EXPECT_FALSE(attempts.lines[1].against) << "one pair is left";
    EXPECT_FALSE(attempts.lines[2].against) << "the reference itself";
    EXPECT_EQ(attempts.lines[0].label, "Row a-1");
    EXPECT_EQ(attempts.lines[1].label, "Row a-2") << "two runs have no median one";
}

/// Runs of search "a" that hold the ball for 10, 20, ... s, the first one longest, as they were
/// played here.
Given runs_of_a(int count) {
    Given c;
    for (int run = 1; run <= count; ++run) {
        const double hold = 10.0 * (count + 1 - run);
        c.rows.push_back({spec_of(fmt::format("a-{}", run), "a", run),
                          "",
                          {episode_row(0, hold, 1), episode_row(1, hold, 1)}});
    }
    return c;
}

/// The same as files, which say of themselves that `command` has found them as runs of `search`.
Given files_of_a(int count, const std::string& search, const std::string& command) {
    Given c = runs_of_a(count);
    for (ComparedRow& row : c.rows) {
        row.spec.network = row.spec.key + ".json";
        row.origin = fmt::format(
            "{}: candidate 7 of run {}-0d4971{}3, version 0.1.0+x; fitness 8 (se 1, n 60) on "
            "validation seeds; found by '{}', seed {}, in 20 generations, 4720 "
            "episodes, 66.3 simulated hours; tested by version 0.1.0+y",
            row.spec.network, search, row.spec.run, command, row.spec.run);
    }
    return c;
}

/// Keys of the rows that are marked as median by hold time.
std::vector<std::string> medians(const Given& given) {
    const Comparison c = given.compared();
    std::vector<std::string> keys;
    for (const ComparedLine& line : c.figures.at(1).lines) {
        if (line.label.ends_with(" (median run)")) keys.push_back(line.key);
    }
    return keys;
}

TEST(Comparison, OfThreeRunsTheMedianOneIsMarked) {
    using testing::ElementsAre;
    using testing::IsEmpty;
    EXPECT_THAT(medians(runs_of_a(1)), IsEmpty());
    EXPECT_THAT(medians(runs_of_a(2)), IsEmpty());
    EXPECT_THAT(medians(runs_of_a(3)), ElementsAre("a-2"));
    EXPECT_THAT(medians(runs_of_a(4)), IsEmpty());
    EXPECT_THAT(medians(runs_of_a(5)), ElementsAre("a-3"));
    Given unfinished = runs_of_a(3);
    unfinished.table.episodes = 2;
    unfinished.rows[2].rows.pop_back();
    EXPECT_THAT(medians(unfinished), IsEmpty()) << "it may still be any of them";
}

TEST(Comparison, FilesHaveAMedianIfOneBudgetFoundThem) {
    using testing::ElementsAre;
    using testing::IsEmpty;
    const std::string command = "k3d-optimizer reproduce table1 --budget paper";
    const Given found = files_of_a(3, "a", command);
    EXPECT_THAT(medians(found), ElementsAre("a-2"));
    EXPECT_THAT(medians(files_of_a(3, "a_both", command)), IsEmpty()) << "runs of another search";
    Given mixed = found;
    mixed.rows[1].spec.network.clear();
    EXPECT_THAT(medians(mixed), IsEmpty()) << "one was made here";
    Given two_budgets = found;
    two_budgets.rows[0].origin = files_of_a(1, "a", "k3d-optimizer run a.toml").rows[0].origin;
    EXPECT_THAT(medians(two_budgets), IsEmpty());
    Given by_hand = found;
    for (ComparedRow& row : by_hand.rows)
        row.origin = "start.toml: Approach and stance set by hand";
    EXPECT_THAT(medians(by_hand), IsEmpty());
    for (ComparedRow& row : by_hand.rows) std::swap(row.spec.network, row.spec.settings_file);
    EXPECT_THAT(medians(by_hand), IsEmpty()) << "settings";
}

ledger::Row possession_row(int episode, double time_s) {
    k3d::episode::Result r;
    r.game = "drill_kick_task";
    r.reason = "done";
    r.metrics = {{"succeeded", 1.0}};
    r.state_hash = "00";
    ledger::Row row;
    row.key = {k3d::optimizer::episode::Phase::Test, 0, 0, episode};
    row.status = "finished";
    row.reason = r.reason;
    row.fitness = -time_s;
    row.result = k3d::episode::to_line(r);
    return row;
}

/// Twelve scenarios by two, in which the reference takes 5 to 10.5 s. The other row is a tenth of
/// that faster in the mean of a scenario's two episodes, in one by more than that and in one
/// slower.
Given two_rounds() {
    Given c;
    c.table.task.name = "possession";
    c.table.episodes = 24;
    c.table.reference = "rules";
    c.rows = {{spec_of("a-1", "a", 1), "", {}}, {spec_of("rules", "", 1), "", {}}};
    for (int episode = 0; episode < 24; ++episode) {
        const double reference = 5.0 + 0.5 * (episode % 12);
        const double swing = episode < 12 ? 2.0 : -2.0;
        c.rows[0].rows.push_back(possession_row(episode, 0.9 * reference + swing));
        c.rows[1].rows.push_back(possession_row(episode, reference));
    }
    return c;
}

TEST(Comparison, PairsOfARepeatedTableAreItsScenarios) {
    const Comparison c = two_rounds().compared();
    const ComparedLine& line = c.figures.at(0).lines.at(0);
    EXPECT_EQ(line.s.n, 24u) << "spread is over episodes";
    ASSERT_TRUE(line.against);
    EXPECT_EQ(line.against->n, 12u);
    EXPECT_NEAR(line.against->difference, -0.775, 1e-12);
    EXPECT_DOUBLE_EQ(line.against->p_permutation, 2.0 / 4096.0) << "all have the same sign";
    // The same share in each scenario: nothing is left of the swing within one.
    EXPECT_NEAR(line.against->ratio_low, 0.9, 1e-12);
    EXPECT_NEAR(line.against->ratio_high, 0.9, 1e-12);
    const std::string said =
        "pairs are the 12 scenarios, each the mean of its episodes; n, mean, sd, se and the mean's "
        "95 % are over single episodes";
    EXPECT_THAT(comparison_text(c), HasSubstr(said));
    EXPECT_THAT(comparison_html(c), HasSubstr(said));
    EXPECT_THAT(comparison_csv(c), HasSubstr(",rules,12,-0.77"));
}

TEST(Comparison, AScenarioIsTheMeanOfWhatBothRowsHave) {
    Given given = two_rounds();
    given.rows[0].rows[15].result.clear();  // scenario 3: episode 3 is left, 6.5 s against 5.85 + 2
    given.rows[1].rows[4].result.clear();   // scenario 4: nothing is left
    given.rows[1].rows[16].result.clear();
    const ComparedLine line = given.compared().figures.at(0).lines.at(0);
    ASSERT_TRUE(line.against);
    EXPECT_EQ(line.against->n, 11u);
    // In sum -9.3 of all twelve, less the -0.65 and -0.7 of these two, and 1.35.
    EXPECT_NEAR(line.against->difference, (-9.3 + 0.65 + 0.7 + 1.35) / 11.0, 1e-12);
}

TEST(Comparison, SomeEpisodesOfADrillAreSomeScenarios) {
    Given given = two_rounds();
    given.table.episodes = 5;
    for (ComparedRow& row : given.rows) row.rows.resize(5);
    const Comparison c = given.compared();
    EXPECT_EQ(c.figures.at(0).lines.at(0).against->n, 5u);
    EXPECT_THAT(comparison_text(c), HasSubstr("pairs are the 5 scenarios"));
}

using Metrics = decltype(k3d::episode::Result::metrics);

/// Gives every episode these figures.
void measure(Given& given, const std::function<Metrics(const ledger::Row&)>& metrics_of) {
    for (ComparedRow& row : given.rows) {
        for (ledger::Row& r : row.rows) {
            auto result = k3d::episode::from_line(r.result);
            result.metrics = metrics_of(r);
            r.result = k3d::episode::to_line(result);
        }
    }
}

TEST(Comparison, RollsAndMatchesArePairedBySeed) {
    Given given = two_rounds();
    given.table.task.name = "ball_prediction";
    measure(given, [](const ledger::Row& r) { return Metrics{{"finish_loss", -r.fitness}}; });
    const Comparison c = given.compared();
    EXPECT_EQ(c.figures.at(0).lines.at(0).against->n, 24u);
    EXPECT_THAT(comparison_text(c), HasSubstr("against: Row rules, by seed\n"));
}

TEST(Comparison, EquationOneHasNoRatio) {
    Given given = two_rounds();
    given.table.task.name = "kick";
    measure(given, [](const ledger::Row& r) {
        // Its means over a scenario are above 0, as those of the distance are.
        return Metrics{{"fitness_capped", r.key.episode < 12 ? -0.5 : 1.0}, {"distance_m", 4.0}};
    });
    const Comparison c = given.compared();
    ASSERT_EQ(c.figures.at(0).name, "fitness_capped");
    EXPECT_FALSE(c.figures.at(0).lines.at(0).against->ratio);
    ASSERT_EQ(c.figures.at(3).name, "distance_m");
    EXPECT_TRUE(c.figures.at(3).lines.at(0).against->ratio);
}

TEST(Comparison, LabelsMayHaveQuotes) {
    Given given = three_rows();
    given.rows[0].spec.label = "Learned before: my \"best\", so far";
    const std::string csv = comparison_csv(given.compared());
    const std::string cell = ",\"Learned before: my \"\"best\"\", so far\",";
    EXPECT_THAT(csv, HasSubstr("table1-greedy,a-1" + cell + "attempts,2,"));
    EXPECT_THAT(csv, HasSubstr("table1-greedy,a-1" + cell + "hold_s_per_end,2,"));
}

TEST(Comparison, EveryEpisodeIsALineOfItsFigures) {
    const std::string csv = episodes_csv(three_rows().compared());
    EXPECT_THAT(csv, testing::StartsWith("row,episode,seed,status,reason,attempts,hold_time_s,"
                                         "passes_completed,kicks\na-1,0,0,finished,"
                                         "\"taker_reached_ball\",4,20,"));
    EXPECT_THAT(csv, HasSubstr("\na-2,1,0,failed,\"no valid result in 4 tries\",,,,\n"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 6);
}

TEST(Comparison, ARowThatIsNotPlayedToTheEndSaysSo) {
    Given given = three_rows();
    given.table.episodes = 2;
    given.rows[2].rows.pop_back();
    const ComparedFigure attempts = given.compared().figures.at(0);
    EXPECT_EQ(attempts.lines[1].label, "Row a-2");
    EXPECT_EQ(attempts.lines[2].label, "Row algorithm2 (unfinished: 1 of 2)");
}

TEST(Comparison, WhatFailedIsCountedAndInNoMean) {
    const Comparison c = three_rows().compared();
    const Circumstances& s = c.circumstances.at(1);
    EXPECT_EQ(s.episodes, 2u);
    EXPECT_EQ(s.failed, 1);
    EXPECT_DOUBLE_EQ(*s.taker_speed, 0.6);
    EXPECT_DOUBLE_EQ(*s.keeper_speed, 0.3);
    EXPECT_DOUBLE_EQ(*s.falls_per_minute, 1.0 / (2.0 * 40.0 / 60.0));
    EXPECT_EQ(s.endings, "no valid result in 4 tries 1, taker_reached_ball 1");
    EXPECT_EQ(c.figures.at(1).lines[1].s.n, 1u);
}

TEST(Comparison, DifferentVersionsAreNamed) {
    Given given = three_rows();
    for (auto& row : given.rows) row.version = "0.1.0+a";
    EXPECT_EQ(warning(given.compared()), "");
    given.rows[1].version = "0.1.0+b";
    const Comparison c = given.compared();
    EXPECT_THAT(warning(c), HasSubstr("0.1.0+a, 0.1.0+b"));
    EXPECT_THAT(comparison_text(c), HasSubstr(warning(c)));
    EXPECT_THAT(comparison_html(c), HasSubstr(warning(c)));
}

TEST(Comparison, ThePaperStandsBeside) {
    const Comparison c = three_rows().compared();
    const std::string text = comparison_text(c);
    EXPECT_THAT(text, HasSubstr("Paper: learned"));
    EXPECT_THAT(text, HasSubstr("4.55 (se 0.129, n 100)"));
    EXPECT_THAT(text, HasSubstr("31.764 (se 0.482, n 100)"));
    EXPECT_THAT(text, HasSubstr("takers m/s 0.60"));
    const std::string html = comparison_html(c);
    EXPECT_THAT(html, HasSubstr("<td>Row a-1</td><td>2</td><td>5.00</td>"));
    const std::string csv = comparison_csv(c);
    EXPECT_THAT(csv, HasSubstr("table1-greedy,a-1,\"Row a-1\",attempts,2,5,"));
    const auto columns = [](const std::string& line) {
        return std::count(line.begin(), line.end(), ',');
    };
    const std::string first = csv.substr(0, csv.find('\n'));
    const std::string last = csv.substr(csv.rfind('\n', csv.size() - 2) + 1);
    EXPECT_EQ(columns(first), columns(comparison_csv_head()));
    EXPECT_EQ(columns(last), columns(comparison_csv_head())) << "the reference, which is without pairs";
    EXPECT_THAT(csv, HasSubstr("table1-greedy,a-1,\"Row a-1\",hold_s_per_end,2,25,"));
}

TEST(Comparison, ATimeLimitIsCountedForAsLongAsItLasted) {
    Given given = three_rows();
    ledger::Row& cut = given.rows[0].rows[1];  // of 30 s
    auto result = k3d::episode::from_line(cut.result);
    result.status = k3d::episode::Status::Truncated;
    cut.result = k3d::episode::to_line(result);
    const Comparison c = given.compared();
    const auto& lines = c.survival;
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[0].s.ended, 1u);
    EXPECT_EQ(lines[0].s.cut, 1u);
    EXPECT_DOUBLE_EQ(*lines[0].s.s_per_end, 50.0);
    ASSERT_TRUE(lines[0].against);
    EXPECT_DOUBLE_EQ(*lines[0].against->ratio, 50.0 / 17.5);
    EXPECT_FALSE(lines[1].against) << "one pair is left";
    EXPECT_FALSE(lines[2].against) << "the reference itself";
    EXPECT_THAT(comparison_text(c), HasSubstr("seconds held per episode that ended"));
    EXPECT_THAT(comparison_html(c),
                HasSubstr("<td>Row a-1</td><td>1</td><td>1</td><td>50.00</td>"));
    given.table.task.name = "kick";
    EXPECT_TRUE(given.compared().survival.empty());
    EXPECT_THAT(comparison_text(given.compared()),
                testing::Not(HasSubstr("per episode that ended")));
}

TEST(Comparison, WhatIsWrittenOfATableIsComputedOnce) {
    Comparison c = three_rows().compared();
    for (ComparedRow& row : c.rows) {
        for (ledger::Row& r : row.rows) r.result = "not to be read again";
    }
    c.figures[0].lines[0].s.mean = 1234.5;
    c.survival[0].s.s_per_end = 2345.5;
    c.circumstances[0].endings = "told once";
    for (const std::string& written : {comparison_text(c), comparison_html(c), comparison_csv(c)}) {
        EXPECT_THAT(written, HasSubstr("1234.5"));
        EXPECT_THAT(written, HasSubstr("2345.5"));
    }
    EXPECT_THAT(comparison_text(c), HasSubstr("ended by told once"));
    EXPECT_THAT(comparison_html(c), HasSubstr("told once"));
    EXPECT_THAT(episodes_csv(c), HasSubstr("\na-1,0,0,finished,\"taker_reached_ball\",4,20,"));
}

}  // namespace
}  // namespace k3d::optimizer::report
