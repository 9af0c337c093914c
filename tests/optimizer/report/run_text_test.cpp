// SPDX-License-Identifier: BSD-3-Clause
// Runs as text: CSV, intervals, the champion's file; and the numbers behind the plots.
#include "optimizer/report/run_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "optimizer/report/curves.h"
#include "optimizer/report/run_page.h"
#include "optimizer/report/svg_plot.h"

namespace k3d::optimizer::report {
namespace {

using episode::Phase;
using testing::HasSubstr;
using testing::Not;

ledger::Row row(Phase phase, int generation, std::uint64_t candidate, int episode, double fitness) {
    ledger::Row r;
    r.key = {phase, generation, candidate, episode};
    r.seed = static_cast<std::uint64_t>(100 + episode);
    r.fingerprint = "f0";
    r.status = "finished";
    r.reason = "ball_out";
    r.fitness = fitness;
    r.wall_s = 1.25;
    r.attempt = 2;
    r.worker = "host:1";
    return r;
}

TEST(RunCsv, CanonicalLeavesOutWhoAndWhen) {
    auto r = row(Phase::Train, 1, 2, 0, 3.5);
    k3d::episode::Result result;
    result.hold_time_s = 3.5;
    result.metrics = {{"a", 1.0}, {"b", 2.0}};
    r.result = k3d::episode::to_line(result);
    r.reason = "a, \"b\"";
    EXPECT_THAT(csv({r}, true),
                HasSubstr("\ntrain,1,2,0,100,f0,finished,\"a, \"\"b\"\"\",3.5,0,3.5,,0,0,0,a=1;b=2,\n"));
    EXPECT_THAT(csv({r}, true), Not(HasSubstr("host:1")));
    EXPECT_THAT(csv({r}, false), HasSubstr(",2,1.250,host:1\n"));
}

TEST(RunCsv, GenerationsHaveTheColumnsOfAllLines) {
    EXPECT_EQ(generations_csv({{{"generation", 0}, {"best", 1.5}},
                               {{"generation", 1}, {"best", 2.5}, {"sigma", 0.5}}}),
              "generation,best,sigma\n0,1.5,\n1,2.5,0.5\n");
}

TEST(Interval, IsStudents) {
    const Statistics s = statistics({1.0, 2.0, 3.0, 4.0});
    EXPECT_NEAR(*half_width_95(s), 3.18244630528 * *s.se, 1e-9);
    EXPECT_FALSE(half_width_95(statistics({1.0})));
    const Statistics many = statistics(std::vector<double>(101, 1.0));
    EXPECT_EQ(*half_width_95(many), 0.0);
    EXPECT_EQ(describe(statistics({})), "none");
}

TEST(Interval, IsStudentsWhateverTheNumberOfEpisodes) {
    // With n - 1 degrees of freedom the distribution reaches 0.975 there.
    for (const auto& [n, t] : {std::pair{2u, 12.7062047362},
                               {12u, 2.2009851601},
                               {60u, 2.0009953781},
                               {120u, 1.9801},
                               {300u, 1.96793},
                               {5000u, 1.9604386}}) {
        std::vector<double> sample(n, 1.0);
        sample[0] = 2.0;
        const Statistics s = statistics(sample);
        EXPECT_NEAR(*half_width_95(s) / *s.se, t, 1e-5) << n;
    }
}

TEST(Champion, IsWrittenAsTheAgentReadsIt) {
    spec::Experiment e;
    e.parameters = {{"keeper.hold", 1.0, 1.0, 0.0, 5.0}, {"role_count", 1.0, 1.0, 0.0, 5.0, true},
                    {"motion.walk.step", 1.0, 1.0, 0.0, 5.0}};
    algorithm::Champion champion;
    champion.payload = std::vector<double>{0.1, 3.0, 0.02};
    EXPECT_EQ(champion_file(e, champion, "who"),
              "# who\nrole_count = 3\n\n[keeper]\nhold = 0.1\n\n[motion.walk]\nstep = 0.02\n");
}

/// Of a search for keeper.hold that found 0.1 among these fixed settings.
std::string file_with(const std::string& settings, const std::string& tuned = "keeper") {
    spec::Experiment e;
    e.task.tuned = tuned;
    e.parameters = {{"keeper.hold", 1.0, 1.0, 0.0, 5.0}};
    e.task.settings = settings;
    algorithm::Champion champion;
    champion.payload = std::vector<double>{0.1};
    return champion_file(e, champion, "who");
}

TEST(Champion, CarriesWhatItsSearchFixedForTheAgents) {
    EXPECT_EQ(file_with("server:physics.stepper=fast agent:keeper.tie=2 keeper:keeper.hold=9"),
              "# who\n\n[keeper]\nhold = 0.1\ntie = 2\n");
}

TEST(Champion, OfTakersCarriesWhatWasFixedForTakers) {
    EXPECT_EQ(file_with("agent:keeper.tie=2 keeper:keeper.x=1 taker:taker.top_speed=0.66", "taker"),
              "# who\n\n[keeper]\nhold = 0.1\ntie = 2\n\n[taker]\ntop_speed = 0.66\n");
}

TEST(Champion, HasFixedTextsInQuotes) {
    EXPECT_EQ(file_with("agent:keeper.policy=handcoded agent:keeper.on=true 'agent:keeper.list=[1, 2]'"),
              "# who\n\n[keeper]\nhold = 0.1\nlist = [1, 2]\non = true\npolicy = \"handcoded\"\n");
}

TEST(Champion, IsANetworkThatSaysWhereItComesFrom) {
    spec::Experiment e;
    e.start_network = network::parse(
        R"({"format": "keepaway3d-network", "version": 1, "description": "by hand",
            "inputs": [{"name": "a"}], "outputs": ["out"],
            "nodes": [{"name": "out", "activation": "linear"}],
            "links": [{"from": "a", "to": "out", "weight": 1}]})",
        "start.json");
    algorithm::Champion weights;
    weights.payload = std::vector<double>{-2.5, 0.5};
    algorithm::Champion grown;
    grown.payload = *e.start_network;
    for (const auto& champion : {weights, grown}) {
        const auto written = network::parse(champion_file(e, champion, "who"), "champion.json");
        EXPECT_EQ(written.description, "who");
    }
    EXPECT_THAT(champion_file(e, weights, "who"), HasSubstr("-2.5"));
}

TEST(Curves, OfTheRowsAlone) {
    const std::string folder = testing::TempDir() + "k3d_curves_" + std::to_string(::getpid());
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    {
        auto ledger = ledger::Ledger::create(folder + "/l.sqlite", {});
        ledger.add({row(Phase::Train, 0, 1, 0, 1.0), row(Phase::Train, 0, 1, 1, 3.0),
                    row(Phase::Train, 0, 2, 0, 5.0), row(Phase::Train, 0, 2, 1, 7.0),
                    row(Phase::Train, 1, 3, 0, 9.0), row(Phase::Test, 0, 3, 0, 4.0),
                    row(Phase::Test, 0, 3, 1, 6.0), row(Phase::Baseline, 0, 0, 0, 1.0),
                    row(Phase::Baseline, 0, 0, 1, 2.0)});
        ledger.save_round({1, "{}",
                           {{{"generation", 0}, {"sigma", 0.5},
                             {"species", {{{"id", 4}, {"size", 2}}}},
                             {"champion", {{"mean", 2.5}, {"se", 0.1}}}}}},
                          {{1, 0, "[0.0]"}, {2, 0, "[10.0]"}});
        const Curves c = curves_of(ledger, {"x"});
        ASSERT_EQ(c.fitness.size(), 2U);
        EXPECT_EQ(c.fitness[0].best, 6.0);
        EXPECT_EQ(c.fitness[0].median, 4.0);
        EXPECT_EQ(*c.fitness[0].all.mean, 4.0);
        EXPECT_EQ(*c.fitness[0].all.se, 2.0);
        EXPECT_EQ(c.champion[0].mean, 2.5);
        EXPECT_EQ(c.logged.at("sigma"), std::vector<double>{0.5});
        EXPECT_EQ(c.species.at(4), std::vector<double>{2.0});
        EXPECT_EQ(c.parameters[0].best[0], 10.0);
        EXPECT_EQ(c.parameters[0].low[0], 1.0);
        EXPECT_TRUE(std::isnan(c.parameters[0].best[1])) << "its candidates are not known yet";
        const Statistics difference = paired_difference(ledger.rows(), 0);
        EXPECT_EQ(difference.n, 2U);
        EXPECT_EQ(*difference.mean, 3.5);
        const Statistics by_scenario = paired_difference(ledger.rows(), 1);
        EXPECT_EQ(by_scenario.n, 1U) << "the same scenario twice is one trial";
        EXPECT_EQ(*by_scenario.mean, 3.5);
    }
    std::filesystem::remove_all(folder);
}

TEST(Plots, HaveNoNumberThatIsNone) {
    const double nan = std::nan("");
    const std::string svg =
        line_plot({"a < b", "x", "y"}, {{"s", {0, 1, 2}, {1, nan, 3}, {0, nan, 2}, {2, nan, 4}}});
    EXPECT_THAT(svg, HasSubstr("a &lt; b"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(line_plot({"empty", "x", "y"}, {}), Not(HasSubstr("inf")));
    EXPECT_THAT(line_plot({"flat", "x", "y"}, {{"s", {0}, {5}, {}, {}}}), Not(HasSubstr("nan")));
    EXPECT_THAT(spread_plot({"t", "x", "y"}, {{"one", {2.0}, 2.0, 2.0, 2.0}}), Not(HasSubstr("nan")));
}

TEST(Plots, TicksAreRoundAndCover) {
    EXPECT_EQ(ticks(0.0, 1.0), (std::vector<double>{0.0, 0.2, 0.4, 0.6000000000000001, 0.8, 1.0}));
    EXPECT_LE(ticks(-3.7, 12.0).front(), -3.7);
    EXPECT_GE(ticks(-3.7, 12.0).back(), 12.0);
}

TEST(RunPage, StatusIsJsonWhateverAProgramPrinted) {
    const auto j = nlohmann::json::parse(status_json({false, 3, 10, 5, 24}, "2 \xff running", "r"));
    EXPECT_EQ(j["status"]["known"], 5);
    EXPECT_EQ(j["status"]["generation"], 3);
}

}  // namespace
}  // namespace k3d::optimizer::report
