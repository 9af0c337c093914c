// SPDX-License-Identifier: BSD-3-Clause
// Jobs and outcomes on their way: the same at the other end, and no text that makes a reader crash.
#include "optimizer/episode/job.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "optimizer/episode/job_match.h"

namespace k3d::optimizer::episode {
namespace {

Job sample() {
    Job job;
    job.run = "a-12345678";
    job.key = {Phase::Validation, 0, 17, 3};
    job.seed = (std::uint64_t{1} << 52) + 7;
    job.attempt = 2;
    job.task.settings = "server:keepaway.limit=5";
    job.settings = {"keeper.hold_threshold=2.5", "a=\"b c\""};
    job.network_path = "keeper.policy";
    job.network = "{\"x\": [1, 2]}\n";
    job.code_version = "0.1.0";
    return job;
}

RC_GTEST_PROP(Job, ReadsBackAsItWas, ()) {
    Job job = sample();
    job.key = {*rc::gen::element(Phase::Train, Phase::Validation, Phase::Test, Phase::Baseline),
               *rc::gen::inRange(0, 1000000), *rc::gen::arbitrary<std::uint64_t>(),
               *rc::gen::inRange(0, 1000)};
    job.seed = *rc::gen::arbitrary<std::uint64_t>();
    job.settings = *rc::gen::container<std::vector<std::string>>(
        rc::gen::string<std::string>(/* printable */));
    for (std::string& text : job.settings) {
        std::erase_if(text, [](char c) { return static_cast<unsigned char>(c) > 126; });
    }
    job.task.worst = *rc::gen::inRange(-1000, 1000) / 7.0;
    RC_ASSERT(job_from_json(to_json(job)) == job);
    RC_ASSERT(fingerprint(job_from_json(to_json(job))) == fingerprint(job));
}

TEST(Job, SaysNothingOfWhatFieldsMean) {
    EXPECT_THAT(to_json(sample()), ::testing::HasSubstr("taker = "));
    EXPECT_THAT(to_json(sample()), ::testing::Not(::testing::HasSubstr("keepaway: the takers")));
}

TEST(Job, TheFingerprintFollowsFromAllButKeyAndSeed) {
    const std::string first = fingerprint(sample());
    Job job = sample();
    job.seed = 1;
    job.key.candidate = 5;
    job.attempt = 4;
    job.run = "b";
    EXPECT_EQ(fingerprint(job), first);
    job.settings[0] = "keeper.hold_threshold=2.6";
    EXPECT_NE(fingerprint(job), first);
    job = sample();
    job.network += " ";
    EXPECT_NE(fingerprint(job), first);
    job = sample();
    job.task.keepers = 4;
    EXPECT_NE(fingerprint(job), first);
    job = sample();
    job.code_version = "0.1.1";
    EXPECT_NE(fingerprint(job), first);
}

TEST(Outcome, ReadsBackAsItWas) {
    Outcome outcome{{Phase::Train, 2, 5, 1}, 99, 3, "abc", Result{}, 1.5, "host:1"};
    outcome.ending->game = "keepaway";
    outcome.ending->hold_time_s = 0.1 + 0.2;
    const Outcome read = outcome_from_json(to_json("run", outcome));
    EXPECT_EQ(read.key, outcome.key);
    EXPECT_EQ(read.attempt, 3);
    EXPECT_EQ(k3d::episode::to_line(*read.ending), k3d::episode::to_line(*outcome.ending));
    outcome.ending = tl::unexpected(Failure{"it \xff died", std::nullopt, 2});
    const Outcome failed = outcome_from_json(to_json("run", outcome));
    EXPECT_EQ(failed.ending.error().reason, "it \xef\xbf\xbd died");
    EXPECT_EQ(failed.ending.error().hopeless, 2);
}

RC_GTEST_PROP(Job, AnyDamageIsReadOrNamed, ()) {
    Outcome outcome{{Phase::Train, 2, 5, 1}, 99, 3, "abc", Result{}, 1.5, "host:1"};
    std::string job = to_json(sample());
    std::string result = to_json("run", outcome);
    for (std::string* text : {&job, &result}) {
        const auto count = *rc::gen::inRange(1, 5);
        for (int i = 0; i < count; ++i) {
            const auto at = *rc::gen::inRange<std::size_t>(0, text->size());
            (*text)[at] = static_cast<char>(*rc::gen::inRange(0, 256));
        }
    }
    try {
        job_from_json(job);
    } catch (const JobError&) {
    }
    try {
        outcome_from_json(result);
    } catch (const JobError&) {
    }
}

TEST(Job, BecomesAMatch) {
    Job job = sample();
    job.network_path.clear();
    const spec::MatchSpec match = match_of(job, "/tmp");
    EXPECT_EQ(match.settings,
              "server:keepaway.limit=5 \"keeper:keeper.hold_threshold=2.5\" "
              "\"keeper:a=\\\"b c\\\"\"");
    EXPECT_EQ(match.seed, job.seed);
}

}  // namespace
}  // namespace k3d::optimizer::episode
