// SPDX-License-Identifier: BSD-3-Clause
// `reproduce` from end to end with real programs, on episodes of a second: it learns, tests, goes on after
// an interruption, repeats nothing, and ends with a report.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

#include "integration/run_rig.h"

namespace k3d::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class Reproduce : public RunRig {
  protected:
    Reproduce() { write("tiny.toml", budget("1", "1")); }

    /// Time limit of the test episodes, and generations of the search.
    static std::string budget(const std::string& limit, const std::string& generations) {
        std::string budget =
            "description = \"a second each\"\nkeepaway_episodes = 2\ntakers = \"greedy\"\n"
            "slow_takers = false\nsettings = \"server:keepaway.limit=" + limit + "\"\n";
        for (const char* left_out :
             {"keepaway_neat", "keepaway_neat_noise", "keepaway_linear_both", "keepaway_linear_hold",
              "keepaway_linear_getopen", "possession_neat", "possession_linear", "ball_prediction"}) {
            budget += std::string("[") + left_out + "]\nruns = 0\n";
        }
        // Settings that an earlier run has found play in place of its own.
        budget += "[keepaway_algorithm2]\nfound = \"" K3D_SOURCE_DIR
                  "/optimizer/experiments/results/keepaway_algorithm2-1.toml\"\n";
        budget +=
            "[kick]\nruns = 1\n[keepaway_linear]\nset = \"'task.settings=server:physics.stepper=fast "
            "server:keepaway.limit=1' algorithm.max_generations=" + generations +
            " algorithm.sampling.episodes=1 "
            "algorithm.sampling.halving_episodes=0 algorithm.sampling.validation_episodes=1 "
            "algorithm.sampling.finalists=1 algorithm.cmaes.population=4\"\n";
        return budget;
    }
    /// A run of a search that can be read no more: its agent tells its settings no longer.
    void leave_unreadable_search() const {
        const std::string agent = K3D_BIN_DIR "/quick_episode";
        std::filesystem::create_symlink(agent, path("agent"));
        std::string text = quick_experiment();
        const std::string key = "agent_program = \"";
        text.replace(text.find(key) + key.size(), agent.size(), path("agent"));
        write("old.toml", text);
        ASSERT_EQ(run({"run", path("old.toml"), "--run", path("out/search/kick-1"), "--set",
                       "algorithm.max_generations=1"},
                      "kick.log"),
                  0)
            << content("kick.log");
        std::filesystem::remove(path("agent"));
    }
    std::string test_ledger(const std::string& row) const {
        return path("out/test/table1-greedy/" + row + "/ledger.sqlite");
    }
    /// As of other code, or on a bad disk: a result that is none, then a ledger that is none.
    void expect_damage_costs_one_row_each() const {
        SQLite::Database(test_ledger("hold"), SQLite::OPEN_READWRITE, 10'000)
            .exec("UPDATE episodes SET result = 'torn' WHERE episode = 1");
        EXPECT_EQ(run(words("table1"), "torn.log"), 1);
        EXPECT_THAT(content("torn.log"), HasSubstr("\nAlways hold: episodes 0; "));
        EXPECT_THAT(content("torn.log"),
                    HasSubstr(" who cannot be read: " + test_ledger("hold") + ": episode test/"));
        EXPECT_THAT(content("torn.log"), ::testing::EndsWith("\n1 rows cannot be read\n"));
        EXPECT_THAT(content("torn.log"), Not(HasSubstr("different versions")));
        EXPECT_THAT(content("out/episodes/table1-greedy.csv"), HasSubstr("\nstill,1,"));
        EXPECT_THAT(content("out/episodes/table1-greedy.csv"), Not(HasSubstr("\nhold,")));

        std::filesystem::remove(test_ledger("still"));
        write("out/test/table1-greedy/still/ledger.sqlite", std::string(200, 'x'));
        EXPECT_EQ(run(words("table1"), "torn.log"), 1);
        const std::string none = test_ledger("still") + ": file is not a database";
        EXPECT_THAT(content("torn.log"), ::testing::EndsWith("\nk3d-optimizer: " + none + "\n"));
        EXPECT_THAT(content("out/tables.txt"), HasSubstr(" who cannot be read: " + none));
        EXPECT_THAT(content("out/episodes/table1-greedy.csv"), HasSubstr("\nrandom,1,"));
        // A report that cannot be written is not why the command has ended.
        std::filesystem::remove(path("out/report.html"));
        std::filesystem::create_directory(path("out/report.html"));
        EXPECT_EQ(run(words("table1"), "torn.log"), 1);
        EXPECT_THAT(content("torn.log"), HasSubstr("no report of what there is: cannot write " +
                                                   path("out/report.html")));
        EXPECT_THAT(content("torn.log"), ::testing::EndsWith("\nk3d-optimizer: " + none + "\n"));
        std::filesystem::remove(path("out/report.html"));
        std::filesystem::remove_all(path("out/test/table1-greedy/still"));
    }
    /// Those of all test episodes, and those that an earlier run has found.
    void expect_refused_settings_are_named() const {
        const std::string sound = content("tiny.toml");
        std::string bad = sound;
        bad.replace(bad.find("keepaway.limit"), 14, "keepaway.lmiit");
        write("tiny.toml", bad);
        EXPECT_EQ(run(words("table1"), "said"), 2);
        EXPECT_THAT(content("said"), HasSubstr("table1-greedy: k3d-server: unknown key"));
        write("found.toml", "[keeper]\nhold_treshold = 2.0\n");
        bad = sound;
        const std::string found =
            K3D_SOURCE_DIR "/optimizer/experiments/results/keepaway_algorithm2-1.toml";
        bad.replace(bad.find(found), found.size(), path("found.toml"));
        write("tiny.toml", bad);
        EXPECT_EQ(run(words("table1"), "said"), 2);
        EXPECT_THAT(content("said"), HasSubstr(path("found.toml") + ": k3d-agent: unknown key"));
        write("tiny.toml", sound);
    }
    std::vector<std::string> words(const std::string& part) const {
        return {"reproduce", part,           "--budget", path("tiny.toml"),
                "--out",     path("out"),    "--jobs",   "2",
                "--experiments", K3D_SOURCE_DIR "/optimizer/experiments"};
    }
};

TEST_F(Reproduce, Table1FromNothingInTwoGoes) {
    process::Child first = start(words("table1"), "first.log");
    // Stopped as soon as there is a finished row of the table, with eight to come.
    const auto begun = [&] {
        return std::filesystem::exists(
            path("out/test/table1-greedy/keepaway_algorithm2-1/ledger.sqlite"));
    };
    ASSERT_TRUE(await(first, begun)) << content("first.log");
    ::kill(first.pid(), SIGTERM);
    const auto exit = first.wait(kRunPatience);
    ASSERT_TRUE(exit);
    EXPECT_EQ(exit->code, 130) << content("first.log");
    EXPECT_THAT(content("first.log"), HasSubstr("the same command goes on"));
    const std::string before = shown("out/test/table1-greedy/keepaway_linear-1", "--csv");

    leave_unreadable_search();
    ASSERT_EQ(run(words("table1"), "second.log"), 0) << content("second.log");
    const std::string said = content("second.log");
    EXPECT_THAT(said, Not(HasSubstr("generation 0:"))) << "the search is not repeated";
    EXPECT_EQ(shown("out/test/table1-greedy/keepaway_linear-1", "--csv"), before);
    EXPECT_THAT(said, HasSubstr("Paper: hand-coded"));
    EXPECT_THAT(said, HasSubstr("Learned: linear by CMA-ES"));
    EXPECT_THAT(said, HasSubstr("keepaway_algorithm2-1.toml: candidate 147 of run"));
    EXPECT_THAT(content("out/tables.csv"),
                HasSubstr("table1-greedy,keepaway_algorithm2-1,\"Algorithm 2, constants by CMA-ES\","));
    EXPECT_THAT(content("out/report.html"), HasSubstr("<h1>The paper's results, reproduced</h1>"));
    EXPECT_THAT(content("out/tables.csv"), HasSubstr("table1-greedy,still,\"Stand still\",hold_time_s,2,"));
    EXPECT_THAT(content("out/searches.csv"), HasSubstr("\"keepaway_linear\",\"1\",\"cmaes\",\"attempts\",\"1\","));

    EXPECT_THAT(content("out/searches.csv"), HasSubstr("\"kick\",\"1\",\"\","));
    EXPECT_THAT(said, HasSubstr("Kick by CMA-ES, run 1")) << "a search that cannot be read is listed";
    EXPECT_THAT(said, HasSubstr("cannot be read: "));
    EXPECT_THAT(content("out/search/keepaway_linear-1/report/report.html"),
                HasSubstr("<pre id=\"overrides\">test.episodes=0\n"));

    expect_damage_costs_one_row_each();
    write("tiny.toml", budget("2", "1"));
    EXPECT_EQ(run(words("table1"), "other.log"), 1) << content("other.log");
    EXPECT_THAT(content("other.log"), HasSubstr("was played with another candidate, task or seed"));
    EXPECT_THAT(content("other.log"), HasSubstr("Delete the folder"));
    EXPECT_THAT(content("other.log"), HasSubstr("what there is: "));
    write("tiny.toml", budget("1", "2"));
    EXPECT_EQ(run(words("table1"), "other.log"), 1) << content("other.log");
    EXPECT_THAT(content("other.log"), HasSubstr("keepaway_linear-1: begun with another overrides"));
}

TEST_F(Reproduce, MistakesAreNamed) {
    std::vector<std::string> bad = words("table1");
    const std::string folder = K3D_SOURCE_DIR "/optimizer/experiments/networks/";
    std::vector<std::string> other = words("table1");
    other.insert(other.end(), {"--champion", folder + "open_linear.json"});
    EXPECT_EQ(run(other, "said"), 2) << content("said");
    EXPECT_THAT(content("said"), HasSubstr("open_linear.json"));
    EXPECT_EQ(run(words("transfer"), "said"), 2);
    EXPECT_THAT(content("said"), HasSubstr("transfer-4v3 wants the champion of keepaway_linear_getopen"));
    const std::string table1 = content("tiny.toml");
    std::string found = table1;
    const std::string none = "[possession_neat]\nruns = 0\n";
    found.replace(found.find(none), none.size(),
                  "[possession_neat]\nfound = \"" + folder + "open_linear.json\"\n");
    write("tiny.toml", found);
    EXPECT_EQ(run(words("possession"), "said"), 2);
    EXPECT_THAT(content("said"), HasSubstr("open_linear.json"));
    write("tiny.toml", table1);
    std::string late = table1;
    const std::string last = "[keepaway_linear_getopen]\nruns = 0\n";
    late.replace(late.find(last), last.size(),
                 "[keepaway_linear_getopen]\nruns = 2\nset = \"algorithm.cmaes.population=1\"\n");
    write("tiny.toml", late);
    EXPECT_EQ(run(words("table1"), "said"), 2);
    EXPECT_THAT(content("said"), HasSubstr("cmaes.population"));
    write("tiny.toml", table1);
    std::string gone = table1;
    gone.replace(gone.find("keepaway_algorithm2-1.toml"), 26, "keepaway_algorithm2-0.toml");
    write("tiny.toml", gone);
    EXPECT_EQ(run(words("table1"), "said"), 2);
    EXPECT_THAT(content("said"), HasSubstr("keepaway_algorithm2-0.toml: cannot read"));
    write("tiny.toml", table1);
    expect_refused_settings_are_named();
    EXPECT_FALSE(std::filesystem::exists(path("out"))) << "nothing was begun";
    bad[3] = "huge";
    EXPECT_EQ(run(bad, "said"), 2);
    EXPECT_THAT(content("said"), HasSubstr("reproduce/huge.toml"));
    EXPECT_EQ(run(words("table2"), "said"), 2);
    EXPECT_THAT(content("said"), HasSubstr("table2"));
}

}  // namespace
}  // namespace k3d::testing
