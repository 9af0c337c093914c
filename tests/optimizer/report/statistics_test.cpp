// SPDX-License-Identifier: BSD-3-Clause
// Statistics against values computed by hand.
#include "optimizer/report/statistics.h"

#include <gtest/gtest.h>

namespace k3d::optimizer::report {
namespace {

TEST(Statistics, OfFourValues) {
    // Mean 5; squares 9 + 1 + 1 + 9 = 20, over 3.
    const Statistics s = statistics({2.0, 4.0, 6.0, 8.0});
    EXPECT_EQ(s.n, 4u);
    EXPECT_DOUBLE_EQ(*s.mean, 5.0);
    EXPECT_NEAR(*s.sd, 2.5819888974716, 1e-12);
    EXPECT_NEAR(*s.se, 1.2909944487358, 1e-12);
}

TEST(Statistics, OfTwoValues) {
    const Statistics s = statistics({-1.0, 1.0});
    EXPECT_DOUBLE_EQ(*s.mean, 0.0);
    EXPECT_NEAR(*s.sd, 1.4142135623731, 1e-12);
    EXPECT_DOUBLE_EQ(*s.se, 1.0);
}

TEST(Statistics, SmallSpreadOnALargeMeanIsNotCancelled) {
    EXPECT_DOUBLE_EQ(*statistics({1e9 + 1, 1e9 + 2, 1e9 + 3}).sd, 1.0);
}

TEST(Statistics, WhatASampleCannotTellIsAbsent) {
    EXPECT_FALSE(statistics({}).mean);
    const Statistics one = statistics({3.0});
    EXPECT_DOUBLE_EQ(*one.mean, 3.0);
    EXPECT_FALSE(one.sd);
    EXPECT_FALSE(one.se);
}

}  // namespace
}  // namespace k3d::optimizer::report
