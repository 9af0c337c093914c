// SPDX-License-Identifier: BSD-3-Clause
// Experiments from end to end: the same bytes on any number of jobs and after any death; what is
// wrong is named.
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>

#include "integration/run_rig.h"

namespace k3d::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// What the folders of an episode's tries are called, by its row: "-train-0-3-1-try-".
std::string tries_of(std::string row) {
    std::replace(row.begin(), row.end(), ',', '-');
    std::size_t end = 0;
    for (int column = 0; column < 4; ++column) end = row.find('-', end) + 1;
    return "-" + row.substr(0, end) + "try-";
}

class Runs : public RunRig {
  protected:
    /// The files of results that servers were started for, a line each.
    std::string started() const { return content("quick.started"); }

    /// None of these rows' episodes was played since `started()` was `before`.
    void expect_not_played(const std::string& rows, const std::string& before) const {
        const std::string since = started().substr(before.size());
        EXPECT_THAT(since, HasSubstr("-try-"));
        std::istringstream lines(rows);
        for (std::string line; std::getline(lines, line);) {
            EXPECT_THAT(since, Not(HasSubstr(tries_of(line))));
        }
    }
};

TEST_F(Runs, FourJobsGiveTheBytesOfOne) {
    ASSERT_EQ(run({"run", path("exp.toml"), "--run", path("one")}, "one.log"), 0)
        << content("one.log");
    ASSERT_EQ(run({"run", path("exp.toml"), "--run", path("four"), "--jobs", "4"}, "four.log"), 0)
        << content("four.log");
    const std::string bytes = canonical("one");
    EXPECT_EQ(bytes, canonical("four"));
    // 4 generations of 6 x 4 episodes; finalists; champion and baseline.
    EXPECT_GE(std::count(bytes.begin(), bytes.end(), '\n'), 4 * 6 * 4 + 4 + 4);
    EXPECT_THAT(bytes, HasSubstr("train,3,"));
    EXPECT_THAT(bytes, HasSubstr("\nvalidation,0,"));
    EXPECT_THAT(bytes, HasSubstr("\nbaseline,0,0,3,"));
    EXPECT_THAT(content("one.log"), HasSubstr("champion on test seeds: "));
    EXPECT_EQ(run({"best", path("one")}, "best.toml"), 0);
    EXPECT_THAT(content("best.toml"), HasSubstr("[keeper]\nhold_threshold = "));
    // A run that is over has nothing left to do.
    EXPECT_EQ(run({"resume", path("one")}, "again.log"), 0);
    EXPECT_EQ(bytes, canonical("one"));
}

TEST_F(Runs, AKilledDaemonGoesOnWhereItWas) {
    ASSERT_EQ(run({"run", path("exp.toml"), "--run", path("calm"), "--jobs", "4"}, "calm.log"), 0);
    std::vector<std::string> words{"run", path("exp.toml"), "--run", path("hit"), "--jobs", "4"};
    std::string before;
    slow_episodes();
    for (int kills = 0; kills < 5; ++kills) {
        const std::string played = started();
        process::Child daemon = start(words, "hit.log");
        ASSERT_TRUE(await(daemon, [&] { return rows_so_far("hit").size() > before.size() + 200; }))
            << content("hit.log");
        daemon.wait(std::chrono::milliseconds(100 * kills));
        daemon.kill();
        words = {"resume", path("hit"), "--jobs", "4"};
        const std::string now = shown("hit", "--csv");
        // Every row that was there is there as it was, worker and all, and nothing is played twice.
        std::istringstream lines(before);
        for (std::string line; std::getline(lines, line);) EXPECT_THAT(now, HasSubstr(line));
        expect_not_played(before, played);
        before = now;
    }
    quick_episodes();
    const std::string played = started();
    ASSERT_EQ(run(words, "hit.log"), 0) << content("hit.log");
    expect_not_played(before, played);
    EXPECT_EQ(failed_tries("hit"), "");
    EXPECT_GT(before.size(), 1000U) << "the daemon was killed before it had done anything";
    EXPECT_EQ(canonical("hit"), canonical("calm"));
}

TEST_F(Runs, WhatADeadDaemonsEpisodesLeftIsNoResult) {
    process::Child daemon = start({"run", path("exp.toml"), "--run", path("a")}, "a.log");
    ASSERT_TRUE(await(daemon, [this] { return plays(); })) << content("a.log");
    daemon.kill();
    // As if the server had just written its line: nobody has read it.
    int left = 0;
    for (const auto& of_a_try : std::filesystem::directory_iterator(path("a/logs"))) {
        std::ofstream(of_a_try.path() / "result.jsonl") << "a line\n";
        ++left;
    }
    EXPECT_GT(left, 0);
    ASSERT_EQ(run({"resume", path("a"), "--jobs", "4"}, "a.log"), 0) << content("a.log");
    EXPECT_EQ(failed_tries("a"), "");
}

TEST_F(Runs, StopsInOrderAndGoesOn) {
    process::Child daemon = start({"run", path("exp.toml"), "--run", path("a")}, "a.log");
    ASSERT_TRUE(await(daemon, [this] { return plays(); })) << content("a.log");
    ::kill(daemon.pid(), SIGTERM);
    const auto exit = daemon.wait(kRunPatience);
    ASSERT_TRUE(exit);
    EXPECT_EQ(exit->code, 130) << content("a.log");
    EXPECT_THAT(content("a.log"), HasSubstr("go on with: k3d-optimizer resume " + path("a")));
    ASSERT_EQ(run({"resume", path("a"), "--jobs", "4"}, "a.log"), 0) << content("a.log");
    EXPECT_EQ(failed_tries("a"), "") << "those it stopped are none";
}

TEST_F(Runs, ASecondDaemonIsTurnedAway) {
    process::Child daemon = start({"run", path("exp.toml"), "--run", path("a")}, "a.log");
    ASSERT_TRUE(await(daemon, [this] { return plays(); })) << content("a.log");
    EXPECT_EQ(run({"resume", path("a")}, "second.log"), 1);
    EXPECT_EQ(content("second.log"), "k3d-optimizer: " + path("a") +
                                         ": another k3d-optimizer is at work here, process " +
                                         std::to_string(daemon.pid()) + "\n");
    EXPECT_EQ(run({"run", path("exp.toml"), "--run", path("a")}, "third.log"), 1);
    EXPECT_THAT(content("third.log"), HasSubstr("has a run already: k3d-optimizer resume "));
}

TEST_F(Runs, AnEpisodeThatNeverWorksIsCountedAsTheWorst) {
    std::string text = quick_experiment();
    const std::string bad = path("broken");
    write("broken", "#!/bin/sh\ncase \"$*\" in *--results*) "
                    "[ $(( $(echo \"$*\" | sed 's/.*--seed \\([0-9]*\\).*/\\1/') % 3 )) = 0 ] && kill -9 $$;; esac\n"
                    "exec " K3D_BIN_DIR "/quick_episode \"$@\"\n");
    std::filesystem::permissions(bad, std::filesystem::perms::owner_all);
    const std::string from = "server_program = \"" K3D_BIN_DIR "/quick_episode";
    text.replace(text.find(from), from.size(), "worst = -5.0\nserver_program = \"" + bad);
    text.replace(text.find("max_generations = 4"), 19, "max_generations = 1");
    write("exp.toml", text);
    ASSERT_EQ(run({"run", path("exp.toml"), "--run", path("a"), "--jobs", "4"}, "a.log"), 0)
        << content("a.log");
    EXPECT_THAT(shown("a", "--csv"), HasSubstr(",failed,no valid result in 4 tries,-5,"));
    EXPECT_THAT(content("a.log"), HasSubstr("try 4 of 4 failed: server: killed by signal 9"));
}

TEST_F(Runs, TheirReportTellsNoPassword) {
    process::Child daemon = start({"run", path("exp.toml"), "--run", path("a"), "--set", "seed=6",
                                   "--nats", "nats://me:sesame@127.0.0.1:1"},
                                  "a.log");
    ASSERT_TRUE(await(daemon, [this] { return tells("a.log", "waiting for nats-server"); }))
        << content("a.log");
    daemon.kill();
    ASSERT_EQ(run({"report", path("a")}, "said"), 0) << content("said");
    EXPECT_THAT(content("a/report/report.html"), HasSubstr(path("exp.toml") + " --set "));
    EXPECT_THAT(content("a/report/report.html"), ::testing::Not(HasSubstr("sesame")));
}

TEST_F(Runs, UsedUpHoursEndItWithAChampion) {
    ASSERT_EQ(run({"run", path("exp.toml"), "--run", path("a"), "--set", "budget.simulated_hours=1e-6",
                   "--set", "algorithm.sampling.validate_every=3"}, "a.log"), 0)
        << content("a.log");
    ASSERT_EQ(run({"show", path("a")}, "shown"), 0);
    EXPECT_THAT(content("shown"), HasSubstr("search ended: simulated_hours"));
    EXPECT_THAT(content("shown"), Not(HasSubstr("champion on test seeds: none")));
}

/// Whether this machine has an IPv6 loopback.
bool has_ipv6() {
    sockaddr_in6 address{};
    address.sin6_family = AF_INET6;
    address.sin6_addr = in6addr_loopback;
    const int fd = ::socket(AF_INET6, SOCK_STREAM, 0);
    const bool bound =
        fd >= 0 && ::bind(fd, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
    if (fd >= 0) ::close(fd);
    return bound;
}

TEST_F(Runs, TellTheirPagesAddressAsABrowserTakesIt) {
    if (!has_ipv6()) GTEST_SKIP() << "no IPv6 here";
    for (const std::string address : {"::1", "::"}) {
        ASSERT_EQ(run({"run", path("exp.toml"), "--run", path("a" + address), "--http", "0",
                       "--listen", address, "--set", "algorithm.max_generations=1"},
                      "a.log"),
                  0)
            << content("a.log");
        EXPECT_THAT(content("a.log"), HasSubstr("page: http://[::1]:"));
    }
}

TEST_F(Runs, ADrillIsATask) {
    const std::string walk = K3D_SOURCE_DIR "/optimizer/experiments/walk_forward.toml";
    const std::vector<std::string> small{
        "run", walk, "--run", path("a"), "--jobs", "2", "--set", "algorithm.max_generations=1",
        "--set", "algorithm.cmaes.population=4", "--set", "algorithm.sampling.episodes=1", "--set",
        "algorithm.sampling.validation_episodes=1", "--set", "algorithm.sampling.finalists=1",
        "--set", "test.episodes=1", "--set", "task.drill=setup.walk_m=1.0 setup.walk_limit_s=3.0"};
    ASSERT_EQ(run(small, "a.log"), 0) << content("a.log");
    const std::string rows = shown("a", "--csv");
    EXPECT_THAT(rows, HasSubstr("\ntrain,0,3,0,"));
    EXPECT_THAT(rows, HasSubstr("speed_mps="));
    EXPECT_THAT(rows, Not(HasSubstr(",failed,")));
    EXPECT_TRUE(std::filesystem::exists(path("a/report/report.html")));
}

TEST_F(Runs, WhatADrillsProgramsRefuseEndsTheRunAtOnce) {
    const std::string walk = K3D_SOURCE_DIR "/optimizer/experiments/walk_forward.toml";
    // A mistake that shows only when it plays.
    write("picky",
          "#!/bin/sh\ncase \"$*\" in *--print-config*) exit 0;; esac\necho no >&2; exit 2\n");
    std::filesystem::permissions(path("picky"), std::filesystem::perms::owner_all);
    EXPECT_EQ(
        run({"run", walk, "--run", path("a"), "--set", "task.server_program=" + path("picky")},
            "said"),
        2);
    EXPECT_THAT(content("said"), HasSubstr("k3d-optimizer: episode train/0/"));
}

TEST_F(Runs, WhatProgramsRefuseIsKnownBeforeThereIsARun) {
    const std::string walk = K3D_SOURCE_DIR "/optimizer/experiments/walk_forward.toml";
    const std::vector<std::pair<std::string, std::string>> mistakes{
        {"task.settings=agent:motion.wlak=3", "task.settings: k3d-agent: unknown key"},
        {"task.settings=server:physics.steper=fast", "task.settings: k3d-server: unknown key"},
        {"test.settings=server:physics.steper=exact", "test.settings: k3d-server: unknown key"},
        {"task.agent_program=/bin/false", "/bin/false --print-fields: exit code 1"}};
    for (const auto& [setting, says] : mistakes) {
        const int code = run({"run", walk, "--run", path("a"), "--set", setting}, "said");
        EXPECT_EQ(code, setting.find("program") == std::string::npos ? 2 : 1);
        EXPECT_THAT(content("said"), HasSubstr(says));
        EXPECT_FALSE(std::filesystem::exists(path("a"))) << "nothing was begun";
    }
}

TEST_F(Runs, ADrillsProgramThatCannotBeStartedIsNoFailureOfACandidate) {
    const std::string walk = K3D_SOURCE_DIR "/optimizer/experiments/walk_forward.toml";
    EXPECT_EQ(run({"run", walk, "--run", path("a"), "--set", "task.server_program=/nowhere/server"},
                  "said"),
              1);
    EXPECT_THAT(content("said"), HasSubstr("cannot start /nowhere/server: No such file"));
    EXPECT_THAT(shown("a", "--csv"), Not(HasSubstr("\ntrain,")));
}

TEST_F(Runs, MistakesAreNamed) {
    write("bad.toml", "name = \"x\"\n[parameters.keeper.hold_treshold]\nlower = 1.0\n");
    EXPECT_EQ(run({"run", path("bad.toml"), "--run", path("x")}, "said"), 2);
    EXPECT_EQ(content("said"), "k3d-optimizer: " + path("bad.toml") +
                                   ":2: unknown key \"parameters.keeper.hold_treshold\", the "
                                   "nearest known one is \"parameters.keeper.hold_threshold\"\n");
    EXPECT_FALSE(std::filesystem::exists(path("x")));
    EXPECT_EQ(run({"run", path("none.toml")}, "said"), 2);
    EXPECT_EQ(content("said"), "k3d-optimizer: cannot read " + path("none.toml") + "\n");
    EXPECT_EQ(run({"resume", path("nowhere")}, "said"), 1);
    EXPECT_THAT(content("said"), HasSubstr(path("nowhere") + " has no run"));
    write("exp2.toml", quick_experiment() + "[algorithm.random_search]\npopulation = -1\n");
    EXPECT_EQ(run({"run", path("exp2.toml"), "--run", path("x")}, "said"), 2);
    EXPECT_THAT(content("said"), HasSubstr("exp2.toml:"));
    std::filesystem::create_directories(path("torn"));
    write("torn/ledger.sqlite", "no database, but long enough to be asked whether it is one: "
                                "one hundred bytes and more of text at the beginning");
    EXPECT_EQ(run({"resume", path("torn")}, "said"), 1);
    EXPECT_THAT(content("said"), HasSubstr("ledger.sqlite: file is not a database"));
}

TEST_F(Runs, NoRoomForTheLedgerIsAnErrorAndTheRunGoesOnLater) {
    ASSERT_EQ(run({"run", path("exp.toml"), "--run", path("calm"), "--jobs", "4"}, "calm.log"), 0);
    // Files may not grow beyond 100 blocks of 1024 bytes, as on a disk that is full.
    process::Child small({{"/bin/bash", "-c",
                           "trap '' XFSZ; ulimit -f 100; exec \"$0\" run \"$1\" --run \"$2\" --jobs 4",
                           std::string(K3D_BIN_DIR) + "/k3d-optimizer", path("exp.toml"), path("a")},
                          path("a.log"), false});
    const auto exit = small.wait(kRunPatience);
    ASSERT_TRUE(exit);
    EXPECT_EQ(exit->code, 1);
    EXPECT_THAT(content("a.log"), HasSubstr("ledger.sqlite: "));
    ASSERT_EQ(run({"resume", path("a"), "--jobs", "4"}, "a.log"), 0) << content("a.log");
    EXPECT_EQ(canonical("a"), canonical("calm"));
}

}  // namespace
}  // namespace k3d::testing
