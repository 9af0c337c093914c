// SPDX-License-Identifier: BSD-3-Clause
// A job that is a drill: the command line that plays it.
#include "optimizer/drill/drill_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace k3d::optimizer::drill {
namespace {

using testing::IsSupersetOf;

std::string value_of(const std::vector<std::string>& words, const std::string& flag) {
    const auto found = std::find(words.begin(), words.end(), flag);
    return found == words.end() ? "" : *(found + 1);
}

TEST(DrillCommand, ChoosesRowSeedAndTableOfTheOneRun) {
    episode::Job job;
    job.task.name = "kick";
    job.task.drill = "setup.kick_limit_s=10.0";
    job.task.settings = "server:vision.noise=false agent:world.ball.alpha=0.9";
    job.key = {episode::Phase::Validation, 0, 7, 14};
    job.seed = 1000;
    job.settings = {"motion.walk.lean=0.1"};
    const auto words = drill_command(job, "/tmp");
    EXPECT_EQ(words[2], "kick_task");
    EXPECT_EQ(value_of(words, "--seed"), "998");
    EXPECT_EQ(value_of(words, "--scenarios"), "validation");
    EXPECT_EQ(value_of(words, "--results"), "/tmp/result.jsonl");
    EXPECT_THAT(words,
                IsSupersetOf({"first=2", "setup.kick_limit_s=10.0", "server:vision.noise=false",
                              "agent:world.ball.alpha=0.9", "keeper:motion.walk.lean=0.1"}))
        << "a second robot must not play with what is judged";
    job.key.phase = episode::Phase::Baseline;
    EXPECT_EQ(value_of(drill_command(job, "/tmp"), "--scenarios"), "test");
}

}  // namespace
}  // namespace k3d::optimizer::drill
