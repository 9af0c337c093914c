// SPDX-License-Identifier: BSD-3-Clause
// Paired tests against values worked out by hand.
#include "optimizer/report/paired.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace k3d::optimizer::report {
namespace {

TEST(Paired, DifferenceRatioAndInterval) {
    const auto p = paired({2.0, 4.0, 6.0, 8.0}, {1.0, 2.0, 5.0, 4.0});
    ASSERT_TRUE(p);
    EXPECT_EQ(p->n, 4u);
    EXPECT_DOUBLE_EQ(p->difference, 2.0);  // 1, 2, 1, 4; sd sqrt(2), t(3) 3.18244630528
    EXPECT_NEAR(p->high - p->difference, 3.18244630528 * std::sqrt(2.0) / 2.0, 1e-9);
    EXPECT_NEAR(p->difference - p->low, p->high - p->difference, 1e-12);
    EXPECT_DOUBLE_EQ(*p->ratio, 20.0 / 12.0);
    EXPECT_LT(p->ratio_low, *p->ratio);
    EXPECT_GT(p->ratio_high, *p->ratio);
    EXPECT_GE(p->ratio_low, 6.0 / 5.0);   // the least favourable pair alone
    EXPECT_LE(p->ratio_high, 2.0);
}

TEST(Paired, PermutationIsExactWhereAllSignsCanBeCounted) {
    // Of the 16 sign patterns of 1, 2, 1, 4 only the two with equal signs reach |sum| 8: 2 / 16.
    const auto p = paired({2.0, 4.0, 6.0, 8.0}, {1.0, 2.0, 5.0, 4.0});
    EXPECT_DOUBLE_EQ(p->p_permutation, 0.125);
    // Ten differences of one sign: 2 / 1024.
    const std::vector<double> a{1.1, 2.3, 3.2, 4.4, 5.6, 6.5, 7.9, 8.7, 9.1, 10.8};
    EXPECT_DOUBLE_EQ(paired(a, std::vector<double>(10, 0.0))->p_permutation, 2.0 / 1024.0);
}

TEST(Paired, PermutationsAreDrawnWhereTheyAreTooMany) {
    // Fifteen ones and nine minus ones: a fair coin's chance to fall at most 9 or at least 15 times
    // of 24.
    std::vector<double> a(24, 1.0);
    std::fill_n(a.begin(), 9, -1.0);
    EXPECT_NEAR(paired(a, std::vector<double>(24, 0.0))->p_permutation, 0.30746, 0.01);
    EXPECT_DOUBLE_EQ(
        paired(std::vector<double>(24, 1.0), std::vector<double>(24, 0.0))->p_permutation,
        1.0 / 20001.0);
}

TEST(Paired, RoundingMakesNoPermutationCountAsLess) {
    // 0.1 + 0.2 - 0.3 is 0 but for rounding, and so is every pattern as far from 0.
    const auto p = paired({0.1, 0.2, -0.3}, {0.0, 0.0, 0.0});
    EXPECT_NE(0.1 + 0.2 - 0.3, 0.0);
    EXPECT_DOUBLE_EQ(p->p_permutation, 1.0);
}

TEST(Paired, EqualSamplesDifferByNothing) {
    const auto p = paired({3.0, 1.0, 2.0}, {3.0, 1.0, 2.0});
    EXPECT_EQ(p->difference, 0.0);
    EXPECT_EQ(p->p_permutation, 1.0);
    EXPECT_EQ(p->p_wilcoxon, 1.0);
    EXPECT_NEAR(p->correlation, 1.0, 1e-12);
}

TEST(Paired, WilcoxonWithTiesAndZeros) {
    // Differences 2 -1 3 0 4 5 -2 1: without the 0 ranks 3.5 -1.5 5 6 7 -3.5 1.5, positive sum 23 of 28.
    // z = (23 - 14 - 0.5) / sqrt(35 - (6 + 6) / 48) = 1.4419, two-sided 0.14933.
    const auto p = paired({2.0, -1.0, 3.0, 0.0, 4.0, 5.0, -2.0, 1.0}, std::vector<double>(8, 0.0));
    EXPECT_NEAR(p->p_wilcoxon, 0.14933, 2e-4);
}

TEST(Paired, TooLittleTellsNothing) {
    EXPECT_FALSE(paired({}, {}));
    EXPECT_FALSE(paired({1.0}, {2.0}));
    EXPECT_FALSE(paired({1.0, 2.0}, {0.0, 0.0})->ratio);
}

TEST(Paired, SignedFiguresHaveNoRatio) {
    EXPECT_TRUE(paired({2.0, 3.0}, {1.0, 2.0})->ratio);
    EXPECT_FALSE(paired({2.0, -1.0}, {1.0, 2.0})->ratio);
    EXPECT_FALSE(paired({2.0, 3.0}, {-1.0, 2.0})->ratio);
}

TEST(Paired, Holm) {
    const std::vector<double> p = holm({0.01, 0.04, 0.03, 0.005});
    EXPECT_DOUBLE_EQ(p[3], 0.02);
    EXPECT_DOUBLE_EQ(p[0], 0.03);
    EXPECT_DOUBLE_EQ(p[2], 0.06);
    EXPECT_DOUBLE_EQ(p[1], 0.06);  // 0.04 itself would stand below its predecessor
    EXPECT_TRUE(holm({}).empty());
    EXPECT_EQ(holm({0.9, 0.8}), (std::vector<double>{1.0, 1.0}));
}

}  // namespace
}  // namespace k3d::optimizer::report
