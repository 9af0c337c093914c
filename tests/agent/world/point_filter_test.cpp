// SPDX-License-Identifier: BSD-3-Clause
#include "agent/world/point_filter.h"

#include <gtest/gtest.h>

#include "common/random/stream.h"

namespace k3d::agent::world {
namespace {

TEST(PointFilter, PredictsADecayingRoll) {
    PointFilter filter;
    filter.start({1.0, 0.0}, 0.01, {2.0, -1.0}, 0.01);
    for (int k = 0; k < 500; ++k) filter.predict(0.02, 1.06, 0.1);
    // Ten seconds on it has rolled v / 1.06.
    EXPECT_NEAR(filter.position().x(), 1.0 + 2.0 / 1.06, 1e-3);
    EXPECT_NEAR(filter.position().y(), -1.0 / 1.06, 1e-3);
    EXPECT_LT(filter.velocity().norm(), 1e-3);
}

TEST(PointFilter, FindsASteadyVelocityInNoise) {
    RandomStream random(1, "test", "filter");
    PointFilter filter;
    filter.start({0.0, 0.0}, 0.02, {0.0, 0.0}, 1.0);
    for (int k = 1; k <= 50; ++k) {
        filter.predict(0.06, 0.0, 0.3);
        filter.measure(Vec2(0.06 * k, 0.0) + 0.02 * Vec2(random.normal(), random.normal()), 0.02);
    }
    EXPECT_NEAR(filter.velocity().x(), 1.0, 0.25);
    EXPECT_NEAR(filter.velocity().x(), 1.0, 3.0 * filter.velocity_sd());
    EXPECT_NEAR(filter.position().x(), 3.0, 0.04);
}

TEST(PointFilter, ADisturbanceLetsTheNextMeasurementSetTheVelocity) {
    PointFilter filter;
    filter.start({0.0, 0.0}, 0.005, {0.0, 0.0}, 0.01);
    filter.predict(0.06, 1.06, 0.1);
    EXPECT_GT(filter.surprise({0.24, 0.0}, 0.01), 100.0);
    filter.disturb(5.0, 0.06);
    EXPECT_LT(filter.surprise({0.24, 0.0}, 0.01), 4.0);
    filter.measure({0.24, 0.0}, 0.01);
    EXPECT_NEAR(filter.velocity().x(), 4.0, 0.2);
}

TEST(PointFilter, ReseatsPositionAndVelocity) {
    PointFilter filter;
    filter.start({2.0, 0.0}, 0.01, {1.0, 0.0}, 0.1);
    filter.reseat({{0.0, 0.0}, 0.0}, {{1.0, 1.0}, kPi / 2.0});
    EXPECT_TRUE(filter.position().isApprox(Vec2(1.0, 3.0), 1e-12));
    EXPECT_TRUE(filter.velocity().isApprox(Vec2(0.0, 1.0), 1e-12));
}

}  // namespace
}  // namespace k3d::agent::world
