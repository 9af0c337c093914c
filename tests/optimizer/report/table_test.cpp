// SPDX-License-Identifier: BSD-3-Clause
// The table of a run, whole, for results made by hand.
#include "optimizer/report/table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace k3d::optimizer::report {
namespace {

using k3d::episode::Status;
using testing::HasSubstr;
using testing::Not;

episode::Result result(double hold, std::optional<int> attempts, int kicks, int passes) {
    episode::Result r;
    r.reason = "taker_reached_ball";
    r.hold_time_s = hold;
    r.attempts = attempts;
    r.kicks = kicks;
    r.passes_completed = passes;
    r.players = {{"left", 1, 1, 0.0, 0.0}, {"right", 1, 0, 0.0, 0.0}};
    return r;
}

TEST(Table, IsWhatTheResultsSay) {
    spec::MatchSpec spec;
    spec.episodes = 3;
    spec.seed = 5;
    spec.keeper_policy = "still";
    report::Run run;
    run.results[0] = result(10.0, 2, 1, 0);
    run.results[1] = result(20.0, std::nullopt, 3, 2);
    run.results[2] = result(30.0, 4, 0, 0);
    run.results[2].status = Status::Truncated;
    run.results[2].reason = "time_limit";
    // Three falls of keepers in one minute of one keeper, none of the taker.
    EXPECT_EQ(table(spec, run),
              "3 keepers (still) against 2 takers (greedy), fast pace, seeds 5 to 7\n"
              "                   n     mean       sd       se\n"
              "hold time, s       3    20.00    10.00     5.77\n"
              "attempts           2     3.00     1.41     1.00\n"
              "kicks              3     1.33     1.53     0.88\n"
              "passes             3     0.67     1.15     0.67\n"
              "ended by: taker_reached_ball 2, time_limit (truncated) 1\n"
              "kicks received by another keeper: 50.0 % (2 of 4)\n"
              "falls per player and minute: 1.50 (keepers 3.00, takers 0.00)\n");
}

TEST(Table, WithoutResultsClaimsNothing) {
    spec::MatchSpec spec;
    report::Run run;
    run.failures[0].reason = "server: exit code 1";
    const std::string text = table(spec, run);
    EXPECT_THAT(text, HasSubstr("hold time, s       0        -        -        -\n"));
    EXPECT_THAT(text, HasSubstr("- (no kicks)"));
    EXPECT_THAT(text, HasSubstr("episodes with a valid result: 0 of 1\n"
                                "  episode 1, seed 1: server: exit code 1\n"));
    EXPECT_THAT(text, Not(HasSubstr("nan")));
}

TEST(Table, NamesForeignProgramsAndInterruption) {
    spec::MatchSpec spec;
    spec.taker_command = "./theirs {port}";
    report::Run run;
    run.interrupted = true;
    EXPECT_THAT(table(spec, run), HasSubstr("3 keepers against 2 takers (./theirs {port}),"));
    EXPECT_THAT(table(spec, run), HasSubstr("0 of 1 (interrupted)"));
}

}  // namespace
}  // namespace k3d::optimizer::report
