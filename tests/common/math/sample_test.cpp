// SPDX-License-Identifier: BSD-3-Clause
// Figures of samples against values computed by hand.
#include "common/math/sample.h"

#include <gtest/gtest.h>

namespace k3d {
namespace {

TEST(Sample, MeanAndSquares) {
    EXPECT_EQ(mean_of({2.0, 4.0, 6.0, 8.0}), 5.0);
    EXPECT_EQ(squares_about({2.0, 4.0, 6.0, 8.0}, 5.0), 20.0);
    EXPECT_EQ(squares_about({1e9 + 1, 1e9 + 2, 1e9 + 3}, 1e9 + 2), 2.0) << "nothing is cancelled";
}

TEST(Sample, QuantilesLieBetweenNeighbours) {
    EXPECT_EQ(quantile({3.0, 1.0, 2.0}, 0.5), 2.0);
    EXPECT_EQ(quantile({1.0, 2.0}, 0.25), 1.25);
    EXPECT_EQ(quantile({7.0}, 0.95), 7.0);
    EXPECT_EQ(quantile({4.0, 3.0, 2.0, 1.0}, 0.0), 1.0);
    EXPECT_EQ(quantile({4.0, 3.0, 2.0, 1.0}, 1.0), 4.0);
}

TEST(SampleDeathTest, NothingCanBeSaidOfNothing) {
    EXPECT_DEATH(mean_of({}), "empty");
    EXPECT_DEATH(quantile({}, 0.5), "empty");
}

}  // namespace
}  // namespace k3d
