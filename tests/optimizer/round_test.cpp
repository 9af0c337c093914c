// SPDX-License-Identifier: BSD-3-Clause
// Rounds: which failure ends a run, and which is tried again.
#include "optimizer/round.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

namespace k3d::optimizer {
namespace {

class RoundOfTwo : public testing::Test {
  protected:
    RoundOfTwo()
        : folder_(testing::TempDir() + "k3d_round_" + std::to_string(::getpid())),
          ledger_(make_ledger()) {}
    ~RoundOfTwo() override { std::filesystem::remove_all(folder_); }

    ledger::Ledger make_ledger() const {
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
        return ledger::Ledger::create(folder_ + "/ledger.sqlite", {});
    }
    Round round(int generation, algorithm::Pool pool = algorithm::Pool::Train) const {
        const JobMaker maker{experiment_, "run"};
        const algorithm::Request request{0, generation, pool, 2, {}};
        Round round(experiment_);
        for (int i = 0; i < 2; ++i) {
            round.add(maker.job(std::nullopt, phase_of(pool), request, i), ledger_);
        }
        return round;
    }
    static episode::Outcome outcome(const episode::Job& job, episode::Ending ending) {
        return {.key = job.key,
                .seed = job.seed,
                .attempt = job.attempt,
                .fingerprint = episode::fingerprint(job),
                .ending = std::move(ending),
                .wall_s = 1.0,
                .worker = "here:1"};
    }
    static episode::Ending refused() {
        return tl::unexpected(episode::Failure{"agent: exit code 2", std::nullopt, 2});
    }

    spec::Experiment experiment_;
    std::string folder_;
    ledger::Ledger ledger_;
};

TEST_F(RoundOfTwo, WhatNobodyCanPlayEndsARunThatHasNoResultYet) {
    Round first = round(0);
    const auto jobs = first.missing();
    try {
        first.take({outcome(jobs[0], refused())}, ledger_);
        ADD_FAILURE() << "the run goes on";
    } catch (const HopelessRun& error) {
        EXPECT_EQ(error.exit_code, 2);
        EXPECT_EQ(error.what(), "episode " + jobs[0].key.text() + ": agent: exit code 2");
    }
}

TEST_F(RoundOfTwo, AWorkerThatCannotPlayDoesNotEndARunThatHasResults) {
    Round first = round(0);
    for (const episode::Job& job : first.missing()) {
        first.take({outcome(job, k3d::episode::Result())}, ledger_);
    }
    ASSERT_TRUE(first.complete());
    Round second = round(1);
    const auto again = second.take({outcome(second.missing()[0], refused())}, ledger_);
    ASSERT_EQ(again.size(), 1U);
    EXPECT_EQ(again[0].attempt, 2);
}

TEST_F(RoundOfTwo, ATestThatNobodyCanPlayIsNoResultOfZero) {
    Round search = round(0);
    for (const episode::Job& job : search.missing()) {
        search.take({outcome(job, k3d::episode::Result())}, ledger_);
    }
    Round test = round(0, algorithm::Pool::Test);
    EXPECT_THROW(test.take({outcome(test.missing()[0], refused())}, ledger_), HopelessRun);
    EXPECT_EQ(ledger_.rows().size(), 2U) << "none of the test";
}

TEST_F(RoundOfTwo, ACandidateHasFailedIfNoneOfItsEpisodesHadAResult) {
    const episode::Failure lost{"the server went away", {}, {}};
    const algorithm::Request both{0, 0, algorithm::Pool::Train, 2, {}};
    Round first = round(0);
    const auto jobs = first.missing();
    first.take({outcome(jobs[0], k3d::episode::Result())}, ledger_);
    std::vector<episode::Job> again{jobs[1]};
    for (int i = 0; i < kTries; ++i)
        again = first.take({outcome(again[0], tl::unexpected(lost))}, ledger_);
    ASSERT_TRUE(first.complete());
    EXPECT_FALSE(first.failed(both));
    EXPECT_EQ(first.score(both).n, 2);

    const algorithm::Request none{0, 1, algorithm::Pool::Train, 2, {}};
    Round second = round(1);
    again = second.missing();
    while (!again.empty()) {
        std::vector<episode::Outcome> outcomes;
        for (const episode::Job& job : again)
            outcomes.push_back(outcome(job, tl::unexpected(lost)));
        again = second.take(outcomes, ledger_);
    }
    ASSERT_TRUE(second.complete());
    EXPECT_TRUE(second.failed(none));
}

TEST_F(RoundOfTwo, ALateFailureOfAnEarlierTryEndsNothing) {
    Round first = round(0);
    const auto jobs = first.missing();
    const episode::Failure lost{"the worker went away", {}, {}};
    ASSERT_EQ(first.take({outcome(jobs[0], tl::unexpected(lost))}, ledger_).size(), 1U);
    EXPECT_TRUE(first.take({outcome(jobs[0], refused())}, ledger_).empty());
    EXPECT_EQ(first.known(), 0U);
}

}  // namespace
}  // namespace k3d::optimizer
