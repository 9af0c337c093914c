// SPDX-License-Identifier: BSD-3-Clause
// Paper section 3.2 on rolls of the reference server: a ball started with v0 runs 0.677 v0, its
// speed being 0.7 v0 after the first contacts and decaying with 1.06 /s from there.
#include "agent/world/ball_finish.h"

#include <gtest/gtest.h>

#include "agent/world/config.h"
#include "common/random/stream.h"

namespace k3d::agent::world {
namespace {

constexpr double kStep = 0.06;  // s between two sees

/// Way of a ball that starts with v0 = 1 m/s, measured at 0.1, 0.5, 1, 2, 3 s: 0.0688, 0.2793,
/// 0.4432, 0.5962, 0.6491; 0.676 at rest.
double measured_way(double time) {
    return time <= 0.0 ? 0.0 : 0.677 - (0.677 - 0.0688) * std::exp(-1.055 * (time - 0.1));
}

TEST(BallFinish, TheCurveOfThisTestIsTheMeasuredOne) {
    EXPECT_NEAR(measured_way(0.1), 0.0688, 0.002);
    EXPECT_NEAR(measured_way(0.5), 0.2793, 0.004);
    EXPECT_NEAR(measured_way(1.0), 0.4432, 0.003);
    EXPECT_NEAR(measured_way(2.0), 0.5962, 0.003);
    EXPECT_NEAR(measured_way(3.0), 0.6491, 0.003);
}

class Rolls : public testing::TestWithParam<double> {};

TEST_P(Rolls, TheStoppingPointIsKnownAfterTwoSees) {
    const double v0 = GetParam();
    const Vec2 start(-1.0, 2.0);
    const Vec2 heading = direction(0.7);
    const Vec2 stop = start + 0.677 * v0 * heading;
    const BallConfig config;
    BallFinish finish(config.alpha, config.lambda);
    for (double time = 0.1; time < 4.0; time += kStep) {
        finish.add(start + v0 * measured_way(time) * heading, time);
        if (time < 0.1 + kStep) continue;
        ASSERT_TRUE(finish.estimate().has_value());
        EXPECT_LT((*finish.estimate() - stop).norm(), 0.02 * v0) << "at " << time;
    }
}

TEST_P(Rolls, NoiseAveragesOutAndTheEstimateConverges) {
    const double v0 = GetParam();
    const BallConfig config;
    RandomStream random(9, "test", "rolls");
    double early = 0.0;
    double late = 0.0;
    constexpr int kRolls = 100;
    for (int roll = 0; roll < kRolls; ++roll) {
        BallFinish finish(config.alpha, config.lambda);
        for (int k = 0; k <= 40; ++k) {
            const double time = 0.1 + k * kStep;
            const Vec2 noise = 0.012 * Vec2(random.normal(), random.normal());  // seen from 4 m
            finish.add(Vec2(v0 * measured_way(time), 0.0) + noise, time);
            if (k == 2) early += (*finish.estimate() - Vec2(0.677 * v0, 0.0)).norm();
            if (k == 20) late += (*finish.estimate() - Vec2(0.677 * v0, 0.0)).norm();
        }
    }
    EXPECT_LT(late / kRolls, 0.12);
    EXPECT_LT(late, 0.6 * early);
}

INSTANTIATE_TEST_SUITE_P(BallFinish, Rolls, testing::Values(1.0, 3.0, 6.0, 10.0),
                         [](const auto& test) {
                             return std::to_string(static_cast<int>(test.param)) + "_m_s";
                         });

TEST(BallFinish, IsTheDiscountedMeanOfTheLinearEstimates) {
    BallFinish finish(0.5, 2.0);
    EXPECT_FALSE(finish.estimate().has_value());
    finish.add({0.0, 0.0}, 0.0);
    EXPECT_FALSE(finish.estimate().has_value());
    finish.add({0.1, 0.0}, 0.1);  // v = 1: 0.6
    finish.add({0.2, 0.4}, 0.3);  // v = (0.5, 2): (0.45, 1.4)
    const double kept = std::exp(-0.2 / 2.0);
    const Vec2 expected = (kept * Vec2(0.6, 0.0) + Vec2(0.45, 1.4)) / (kept + 1.0);
    EXPECT_TRUE(finish.estimate()->isApprox(expected, 1e-12));
}

TEST(BallFinish, AResetForgetsTheRollBefore) {
    BallFinish finish(0.914, 0.5);
    finish.add({0.0, 0.0}, 0.0);
    finish.add({1.0, 0.0}, 0.06);
    finish.reset();
    EXPECT_FALSE(finish.estimate().has_value());
    finish.add({1.0, 0.0}, 0.12);
    finish.add({1.0, 0.0}, 0.12);  // the same moment twice tells nothing
    EXPECT_FALSE(finish.estimate().has_value());
    finish.add({1.0, 0.0}, 0.18);
    EXPECT_TRUE(finish.estimate()->isApprox(Vec2(1.0, 0.0), 1e-12));
}

}  // namespace
}  // namespace k3d::agent::world
