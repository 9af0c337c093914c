// SPDX-License-Identifier: BSD-3-Clause
// How long possession lasts where the limit cuts episodes off, against published and hand-made
// figures.
#include "optimizer/report/survival.h"

#include <gtest/gtest.h>

#include <cmath>

namespace k3d::optimizer::report {
namespace {

std::vector<Lifetime> all_ended(const std::vector<double>& times) {
    std::vector<Lifetime> lives;
    for (const double s : times) lives.push_back({s, true});
    return lives;
}

/// Weeks of remission of 21 pairs of patients, treated and not (Freireich et al., Blood 21, 1963):
/// the textbook case of the log-rank test.
const std::vector<Lifetime> kTreated{
    {10, true},  {7, true},   {32, false}, {23, true},  {22, true},  {6, true},   {16, true},
    {34, false}, {32, false}, {25, false}, {11, false}, {20, false}, {19, false}, {6, true},
    {17, false}, {35, false}, {6, true},   {13, true},  {9, false},  {6, false},  {10, false}};
const std::vector<Lifetime> kUntreated =
    all_ended({1, 22, 3, 12, 8, 17, 2, 11, 8, 12, 2, 5, 4, 15, 8, 23, 5, 11, 4, 1, 8});

TEST(Survival, TheTextbookCase) {
    const Survival treated = survival(kTreated);
    EXPECT_EQ(treated.ended, 9u);
    EXPECT_EQ(treated.cut, 12u);
    EXPECT_DOUBLE_EQ(*treated.s_per_end, 359.0 / 9.0);
    EXPECT_DOUBLE_EQ(*survival(kUntreated).s_per_end, 182.0 / 21.0);
    const auto test = survival_test(kTreated, kUntreated);
    ASSERT_TRUE(test);
    // Published chi-square 16.79 with one degree of freedom.
    EXPECT_NEAR(test->p_log_rank, std::erfc(std::sqrt(16.79 / 2.0)), 2e-7);
    EXPECT_EQ(test->pairs, 21u);
    EXPECT_DOUBLE_EQ(*test->ratio, (359.0 / 9.0) / (182.0 / 21.0));
    EXPECT_GT(test->ratio_low, 1.0);
    EXPECT_GT(test->ratio_high, *test->ratio);
}

TEST(Survival, TheOtherWayRoundItIsTheSame) {
    EXPECT_NEAR(survival_test(kUntreated, kTreated)->p_log_rank,
                survival_test(kTreated, kUntreated)->p_log_rank, 1e-12);
}

TEST(Survival, EqualSamplesDifferByNothing) {
    const auto test = survival_test(kTreated, kTreated);
    EXPECT_NEAR(test->p_log_rank, 1.0, 1e-12);
    EXPECT_DOUBLE_EQ(*test->ratio, 1.0);
    EXPECT_DOUBLE_EQ(test->ratio_low, 1.0) << "pairs are drawn together";
}

TEST(Survival, ALimitThatCutsDoesNotShortenWhatEndsAtOneRate) {
    // Quantiles of exponential lifetimes of mean 100, the same cut at 50: 39 % end, and s_per_end
    // stays.
    std::vector<Lifetime> whole, cut;
    for (int i = 0; i < 1000; ++i) {
        const double s = -100.0 * std::log(1.0 - (i + 0.5) / 1000.0);
        whole.push_back({s, true});
        cut.push_back({std::min(s, 50.0), s < 50.0});
    }
    EXPECT_NEAR(*survival(whole).s_per_end, 100.0, 0.2);
    EXPECT_NEAR(*survival(cut).s_per_end, 100.0, 0.5);
    EXPECT_NEAR(static_cast<double>(survival(cut).ended) / 1000.0, 1.0 - std::exp(-0.5), 0.001);
}

TEST(Survival, WhatNeverEndsHasNoRatio) {
    const std::vector<Lifetime> endless{{300, false}, {300, false}, {300, false}};
    EXPECT_FALSE(survival(endless).s_per_end);
    const auto test = survival_test(endless, all_ended({10, 20, 30}));
    ASSERT_TRUE(test);
    EXPECT_FALSE(test->ratio);
    // At 10, 20, 30 s one of 3, 2, 1 of six, five, four ends: excess -1.85, variance 0.6775.
    EXPECT_NEAR(test->p_log_rank, std::erfc(1.85 / std::sqrt(2.0 * 0.6775)), 1e-9);
    EXPECT_DOUBLE_EQ(survival_test(endless, endless)->p_log_rank, 1.0);
}

TEST(Survival, TooLittleTellsNothing) {
    EXPECT_FALSE(survival({}).s_per_end);
    EXPECT_FALSE(survival_test({}, {}));
    EXPECT_FALSE(survival_test({{1.0, true}}, {{2.0, true}}));
}

}  // namespace
}  // namespace k3d::optimizer::report
