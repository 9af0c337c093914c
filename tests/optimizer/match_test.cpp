// SPDX-License-Identifier: BSD-3-Clause
// The match loop with programs that play well, die, hang or lie: it ends, it says why, and leaves
// no process behind.
#include "optimizer/match.h"

#include <gmock/gmock.h>

#include "tests/optimizer/fake_programs.h"

namespace k3d::optimizer {
namespace {

using testing::HasSubstr;
using testing::Not;

class Match : public FakePrograms {
  protected:
    report::Run play() {
        report::Progress progress(spec_, progress_, false);
        return play_match(spec_, progress);
    }

    std::string failure_of_play() {
        try {
            play();
        } catch (const HopelessRun& error) {
            return "exit code " + std::to_string(error.exit_code) + ", " + error.what();
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "no failure";
    }

    /// Plays one episode without another try, and gives the reason of its failure.
    std::string one_failure() {
        spec_.retries = 0;
        const report::Run run = play();
        EXPECT_TRUE(run.results.empty());
        EXPECT_TRUE(all_gone());
        return run.failures.empty() ? "none" : run.failures.at(0).reason;
    }

    std::ostringstream progress_;
};

TEST_F(Match, LinesAreThoseOfTheSeedsWhateverRunsBesideWhat) {
    spec_.episodes = 4;
    spec_.seed = 7;
    server_plays("sleep 0.$(( (12 - seed) )); result >> $results");  // the first ends last
    play();
    const std::string one_at_a_time = content(spec_.results);
    std::filesystem::remove(base_ + "/pids");
    spec_.jobs = 4;
    const report::Run run = play();
    EXPECT_EQ(content(spec_.results), one_at_a_time);
    EXPECT_THAT(one_at_a_time, HasSubstr("\"seed\":10,"));
    EXPECT_EQ(run.results.size(), 4u);
    EXPECT_EQ(run.results.at(2).seed, 9u);
    EXPECT_EQ(run.results.at(2).attempts, 2) << "one of each keeper's telemetry";
    const auto all = pids();
    EXPECT_EQ(std::set<pid_t>(all.begin(), all.end()).size(), 16u) << "new processes each time";
    EXPECT_TRUE(all_gone());
    EXPECT_FALSE(temporary_files_left());
    EXPECT_THAT(progress_.str(), HasSubstr("episode 4/4 seed 10: ball_out after 10.50 s, 2 kicks, "
                                           "1 pass ("));
}

TEST_F(Match, AServerThatDiesIsTriedAgain) {
    server_plays("[ -e $base/died ] || { : > $base/died; kill -9 $$; }; " +
                 std::string(kOneResult));
    const report::Run run = play();
    EXPECT_EQ(run.results.size(), 1u);
    EXPECT_THAT(progress_.str(), HasSubstr("try 1 of 4 failed: server: killed by signal 9"));
    EXPECT_THAT(progress_.str(), Not(HasSubstr("given up")));
    EXPECT_TRUE(all_gone());
    EXPECT_TRUE(temporary_files_left()) << "the failed try's logs";
}

TEST_F(Match, TriesEndAfterTheRetries) {
    spec_.retries = 2;
    spec_.episodes = 2;
    server_plays("[ $seed = 2 ] || status=diverged; " + std::string(kOneResult));
    const report::Run run = play();
    EXPECT_EQ(run.failures.at(0).reason, "diverged: ball_out");
    EXPECT_EQ(run.results.at(1).seed, 2u);
    EXPECT_THAT(progress_.str(), HasSubstr("try 3 of 3 failed: diverged: ball_out"));
    EXPECT_EQ(pids().size(), 4u * (3 + 1));
    EXPECT_THAT(content(spec_.results), HasSubstr("\"status\":\"diverged\""));
    EXPECT_THAT(content(spec_.results), HasSubstr("\"seed\":2,"));
}

TEST_F(Match, AHangEndsAtTheDeadline) {
    spec_.deadline_s = 0.4;
    server_plays("sleep 600");
    EXPECT_EQ(one_failure(), "no end after 0.4 s");
}

TEST_F(Match, AServerThatIsNeverReadyIsGivenUp) {
    spec_.lobby_s = 0.3;
    script("server", "sleep 600");
    EXPECT_EQ(one_failure(), "the server is not ready after 0.3 s");
}

TEST_F(Match, ALineThatIsNoResultIsNamed) {
    server_plays("echo '{\"schema\": 1}' >> $results");
    EXPECT_THAT(one_failure(), HasSubstr("no game"));
}

TEST_F(Match, NoLineIsNoResult) {
    server_plays("exit 0");
    EXPECT_THAT(one_failure(), HasSubstr("result.jsonl has 0 lines, not 1"));
}

TEST_F(Match, AnotherSeedsLineIsNoResult) {
    server_plays("seed=99; result >> $results");
    EXPECT_EQ(one_failure(), "the result is of game 'keepaway', seed 99");
}

TEST_F(Match, ALostAgentIsNamedWithItsLastWords) {
    agents_play(
        "[ $role$unum = keeper2 ] && { echo leg broken; echo $$ > $base/gone; exit 7; }; "
        "kick; until_end");
    // It goes when the agent has been reaped: until then there is somebody of its number.
    server_plays(
        "until [ -s $base/gone ] && ! kill -0 $(cat $base/gone) 2>/dev/null; do sleep 0.02; done; "
        "status=agent_lost; result >> $results; exit 3");
    EXPECT_EQ(one_failure(),
              "agent_lost: ball_out; first to go: keeper 2: exit code 7: leg broken");
}

TEST_F(Match, AServerThatIgnoresALostAgentIsNotWaitedFor) {
    agents_play("[ $role$unum = taker1 ] && exit 7; kick; until_end");
    server_plays("sleep 600");
    EXPECT_EQ(one_failure(), "taker 1: exit code 7");
}

TEST_F(Match, TelemetryOfAKeeperMustBeWhole) {
    agents_play("[ $role = taker ] || printf '{\"time\": 1' > $telemetry; until_end");
    EXPECT_THAT(one_failure(), HasSubstr("keeper-1.telemetry.jsonl:1: the line has no end"));
}

TEST_F(Match, WhatEveryTryWouldMeetEndsTheRun) {
    script("server", "echo 'cannot listen on 127.0.0.1:8080: Address already in use' >&2; exit 1");
    EXPECT_THAT(failure_of_play(), HasSubstr("exit code 1, server: exit code 1: cannot listen on "
                                             "127.0.0.1:8080: Address already in use; logs in /"));
    EXPECT_EQ(pids().size(), 1u);
}

TEST_F(Match, ABadFlagOfAnAgentEndsTheRun) {
    agents_play("echo \"--keeper-policy: 'x' is unknown\"; echo Run with --help; exit 2");
    // All of them end so; which is seen first is chance.
    EXPECT_THAT(failure_of_play(),
                testing::ContainsRegex("exit code 2, (keeper|taker) [1-3]: exit code 2: "
                                       "--keeper-policy: 'x' is unknown; logs in /"));
    EXPECT_TRUE(all_gone());
}

TEST_F(Match, AMissingProgramIsNamed) {
    spec_.server_program = "/nowhere/server";
    EXPECT_EQ(failure_of_play(), "cannot start /nowhere/server: No such file or directory");
    EXPECT_FALSE(temporary_files_left());
    spec_.server_program = base_ + "/server";
    spec_.taker_command = "/nowhere/taker {unum}";
    EXPECT_THAT(failure_of_play(),
                HasSubstr("cannot start /nowhere/taker: No such file or directory"));
    EXPECT_TRUE(all_gone());
}

TEST_F(Match, ForeignProgramsTakeSeatsAndNeedNotNoticeTheEnd) {
    script("theirs", "echo $* >> $base/seats; exec sleep 600");
    server_plays(
        "until [ \"$(grep -cs . $base/seats)\" = 2 ]; do sleep 0.02; done; result >> $results");
    spec_.keeper_command = base_ + "/theirs '{team} {unum}' {host}";
    const report::Run run = play();
    EXPECT_EQ(run.results.at(0).attempts, std::nullopt);
    EXPECT_THAT(content(base_ + "/seats"), HasSubstr("Keepers 1 127.0.0.1\n"));
    EXPECT_THAT(content(base_ + "/seats"), HasSubstr("Keepers 2 127.0.0.1\n"));
    EXPECT_TRUE(all_gone());
}

TEST_F(Match, TheUsersWishToStopEndsAllProcesses) {
    spec_.episodes = 100;
    server_plays("[ $seed = 1 ] && { result >> $results; exit; }; kill -INT " +
                 std::to_string(::getpid()) + "; sleep 600");
    const report::Run run = play();
    EXPECT_TRUE(run.interrupted);
    EXPECT_EQ(run.results.size(), 1u);
    EXPECT_THAT(content(spec_.results), HasSubstr("\"seed\":1,"));
    EXPECT_TRUE(all_gone());
    EXPECT_FALSE(temporary_files_left());
}

TEST_F(Match, ThePageKeepsItsPortAndIsSaidOnce) {
    spec_.episodes = 3;
    spec_.http_port = 0;
    server_plays("echo $http >> $base/http; " + std::string(kOneResult));
    // Port 0 becomes 8123 in the ready line, as a port of the system's choice would.
    const std::string script = content(base_ + "/server");
    std::ofstream(base_ + "/server") << script.substr(0, script.find("port=$((")) +
                                            "[ $http = 0 ] && http=8123\n" +
                                            script.substr(script.find("port=$(("));
    play();
    const std::string said = progress_.str();
    EXPECT_THAT(said, HasSubstr("page: http://127.0.0.1:8123/\n"));
    EXPECT_EQ(said.find("page:"), said.rfind("page:"));
    EXPECT_EQ(content(base_ + "/http"), "8123\n8123\n8123\n");
}

TEST_F(Match, OnlyOneServerHasThePage) {
    spec_.episodes = 4;
    spec_.jobs = 2;
    spec_.http_port = 8123;
    server_plays(
        "[ -z \"$http\" ] || mkdir $base/page || : > $base/busy; sleep 0.1; "
        "result >> $results; [ -z \"$http\" ] || { : > $base/had; rmdir $base/page; }");
    play();
    EXPECT_TRUE(std::filesystem::exists(base_ + "/had"));
    EXPECT_FALSE(std::filesystem::exists(base_ + "/busy"));
}

TEST_F(Match, ANamedLogFolderKeepsAll) {
    spec_.log_folder = base_ + "/logs";
    play();
    play();  // over what the first run left
    EXPECT_EQ(content(base_ + "/logs/seed-1/try-1/keeper-2.telemetry.jsonl"),
              "{\"time\": 1.5, \"event\": \"kick_attempt\"}\n");
    EXPECT_TRUE(std::filesystem::exists(base_ + "/logs/seed-1/try-1/server.log"));
}

TEST_F(Match, ALogFolderThatCannotBeIsNamed) {
    spec_.log_folder = base_ + "/server/logs";
    EXPECT_THAT(failure_of_play(), HasSubstr("log folder " + spec_.log_folder + ": "));
}

}  // namespace
}  // namespace k3d::optimizer
