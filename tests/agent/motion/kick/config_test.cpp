// SPDX-License-Identifier: BSD-3-Clause
// How far and near swings are mixed for a wanted distance.
#include "agent/motion/kick/config.h"

#include <gtest/gtest.h>

namespace k3d::agent::kick {
namespace {

TEST(KickMix, GoesFromNearToFarAndNoFurther) {
    const Config c;
    EXPECT_EQ(c.far_share(0.5), 0.0);
    EXPECT_EQ(c.far_share(c.near.reach_m), 0.0);
    EXPECT_EQ(c.far_share(c.far.reach_m), 1.0);
    EXPECT_EQ(c.far_share(9.0), 1.0);
    EXPECT_EQ(c.reach_for(2.0), c.near.reach_m);
    EXPECT_EQ(c.reach_for(4.7), 4.7);
    EXPECT_EQ(c.reach_for(c.farthest.from_m), c.far.reach_m);
    EXPECT_EQ(c.reach_for(9.0), c.farthest.swing.reach_m);
    double before = 0.0;
    for (double wanted = c.near.reach_m + 0.1; wanted <= c.far.reach_m; wanted += 0.1) {
        EXPECT_GT(c.far_share(wanted), before) << wanted;
        before = c.far_share(wanted);
    }
}

TEST(KickMix, ReachesInTheWrongOrderGiveOneOfTheTwo) {
    Config c;
    c.near.reach_m = 6.0;
    c.far.reach_m = 4.0;
    for (const double wanted : {3.0, 5.0, 7.0}) {
        const double share = c.far_share(wanted);
        EXPECT_TRUE(share == 0.0 || share == 1.0) << wanted;
    }
}

}  // namespace
}  // namespace k3d::agent::kick
