// SPDX-License-Identifier: BSD-3-Clause
// The line that tells how far a search or a test has come.
#include "optimizer/report/run_progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <sstream>
#include <thread>

namespace k3d::optimizer::report {
namespace {

constexpr std::chrono::milliseconds kUntilShownAgain{250};

std::vector<ledger::Row> finished(std::size_t count) {
    ledger::Row row;
    row.status = "finished";
    row.simulated_s = 60.0;
    return std::vector<ledger::Row>(count, row);
}

class RunProgressTest : public testing::Test {
  protected:
    std::string shown(const RunView& view, std::size_t news) {
        std::this_thread::sleep_for(kUntilShownAgain);
        out_.str("");
        progress_.show(view, finished(news), "2 running");
        return out_.str();
    }

    std::ostringstream out_;
    RunProgress progress_{out_, true};
};

TEST_F(RunProgressTest, TellsTheGenerationAndWhenTheSearchEnds) {
    const std::string text = shown({false, 3, 20, 10, 40}, 10);
    EXPECT_THAT(text, testing::HasSubstr("generation 3: 10 of 40 episodes, 2 running, "));
    EXPECT_THAT(text, testing::HasSubstr(", ends in "));
}

TEST_F(RunProgressTest, TellsNoEndOfASearchWithoutLimit) {
    EXPECT_THAT(shown({false, 3, 1000000, 10, 40}, 10),
                testing::Not(testing::HasSubstr("ends in")));
}

TEST_F(RunProgressTest, RatesOfWhatHasBegunAreItsOwn) {
    shown({false, 0, 1, 40, 40}, 1000);
    progress_.begin("a row");
    const std::string before = shown({true, 0, 0, 0, 20}, 0);
    EXPECT_THAT(before,
                testing::HasSubstr("test: 0 of 20 episodes, 2 running, 0.0 episodes per min"));
    EXPECT_THAT(before, testing::Not(testing::HasSubstr("ends in")));  // nothing to tell it by
    EXPECT_THAT(progress_.rates(), testing::StartsWith("0.0 episodes per min"));  // the page's
    EXPECT_THAT(shown({true, 0, 0, 1, 20}, 1), testing::HasSubstr(", ends in "));
    EXPECT_THAT(progress_.summary(), testing::Not(testing::StartsWith("0.0 ")));  // of all
}

TEST_F(RunProgressTest, TheTestOfARunIsNotToldByItsSearch) {
    shown({false, 0, 1, 40, 40}, 1000);
    EXPECT_THAT(shown({true, 0, 0, 0, 20}, 0), testing::HasSubstr(" 0.0 episodes per min"));
}

TEST_F(RunProgressTest, FailuresAreThoseOfTheStageThatHadThem) {
    auto failed = finished(1);
    failed.front().status = "failed";
    progress_.show({true, 0, 0, 1, 20}, failed, "2 running");
    EXPECT_THAT(shown({true, 0, 0, 2, 20}, 1), testing::HasSubstr(", 1 failed"));
    progress_.begin("the next row");
    EXPECT_THAT(shown({true, 0, 0, 0, 20}, 0), testing::Not(testing::HasSubstr("failed")));
    EXPECT_THAT(progress_.rates(), testing::Not(testing::HasSubstr("failed")));
    EXPECT_THAT(progress_.summary(), testing::EndsWith(", 1 failed"));  // of all
}

}  // namespace
}  // namespace k3d::optimizer::report
