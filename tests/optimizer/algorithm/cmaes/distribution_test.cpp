// SPDX-License-Identifier: BSD-3-Clause
// Tests of optimizer/algorithm/cmaes/distribution: constants of the tutorial, one update by hand,
// bits that survive a save.
#include "optimizer/algorithm/cmaes/distribution.h"

#include <gtest/gtest.h>

namespace k3d::optimizer::algorithm::cmaes {
namespace {

TEST(Constants, DefaultPopulation) {
    EXPECT_EQ(default_population(1), 4);
    EXPECT_EQ(default_population(10), 10);
    EXPECT_EQ(default_population(20), 12);
    EXPECT_EQ(default_population(33), 14);
}

TEST(Constants, TenDimensions) {
    const Constants c = constants(10, 10, true, false);
    EXPECT_EQ(c.parents, 5);
    EXPECT_NEAR(c.weights.head(5).sum(), 1.0, 1e-15);
    EXPECT_NEAR(c.weights[0], 0.4563, 5e-5);  // ln 5.5 over the sum of ln 5.5 - ln i
    EXPECT_NEAR(c.mu_eff, 3.1673, 5e-5);
    EXPECT_NEAR(c.c_1, 2.0 / (11.3 * 11.3 + c.mu_eff), 1e-15);
    EXPECT_NEAR(c.chi_n, 3.0847, 5e-4);
    EXPECT_LT(c.weights.tail(4).maxCoeff(), 0.0);
    // The negative weights may not make the covariance indefinite: what is taken away is bounded.
    EXPECT_LE(c.c_1 + c.c_mu * (c.weights.cwiseMax(0.0).sum() - 10 * c.weights.cwiseMin(0.0).sum()),
              1.0 + 1e-12);
    EXPECT_EQ(constants(10, 10, false, false).weights.tail(5).cwiseAbs().maxCoeff(), 0.0);
}

TEST(Distribution, OneUpdateByHand) {
    const Constants c = constants(2, 4, false, false);
    Distribution d = start(c, Eigen::Vector2d(1.0, 2.0), 0.5);
    Eigen::MatrixXd ranked(2, 4);
    ranked << 1.0, 0.0, -1.0, 2.0,  //
        0.0, 1.0, 1.0, 0.0;
    update(c, d, ranked, Eigen::Vector2d::Ones());
    const double w0 = c.weights[0];
    const double w1 = c.weights[1];
    EXPECT_NEAR(d.mean[0], 1.0 + 0.5 * w0, 1e-15);
    EXPECT_NEAR(d.mean[1], 2.0 + 0.5 * w1, 1e-15);
    const double gain = std::sqrt(c.c_sigma * (2.0 - c.c_sigma) * c.mu_eff);
    EXPECT_NEAR(d.path_sigma[0], gain * w0, 1e-15);
    const double pc0 = std::sqrt(c.c_c * (2.0 - c.c_c) * c.mu_eff) * w0;
    EXPECT_NEAR(d.covariance(0, 0), 1.0 - c.c_1 - c.c_mu + c.c_1 * pc0 * pc0 + c.c_mu * w0, 1e-14);
    EXPECT_NEAR(d.sigma, 0.5 * std::exp(c.c_sigma / c.d_sigma * (d.path_sigma.norm() / c.chi_n - 1.0)),
                1e-15);
}

TEST(Distribution, StaysPositiveDefiniteUnderRandomRanks) {
    for (const bool separable : {false, true}) {
        const Constants c = constants(6, 20, true, separable);
        Distribution d = start(c, Eigen::VectorXd::Zero(6), 1.0);
        RandomStream stream(2, "test", "steps");
        for (int i = 0; i < 500; ++i) {
            update(c, d, draw_steps(c, d, stream), Eigen::VectorXd::Ones(6));
            ASSERT_GT(d.lengths.minCoeff(), 0.0) << i;
            ASSERT_TRUE(d.covariance.allFinite()) << i;
        }
    }
}

TEST(Distribution, StepsOfWholeNumbersKeepTheirFloor) {
    const Constants c = constants(2, 6, true, false);
    const Distribution d = start(c, Eigen::VectorXd::Zero(2), 0.01);
    const Eigen::VectorXd factors = step_factors(c, d, Eigen::Vector2d(0.25, 0.0));
    EXPECT_DOUBLE_EQ(factors[0], 25.0);
    EXPECT_EQ(factors[1], 1.0);
}

TEST(Distribution, SavedBitsAreTheSame) {
    for (const bool separable : {false, true}) {
        const Constants c = constants(5, 8, true, separable);
        Distribution d = start(c, Eigen::VectorXd::Constant(5, 1.0 / 3.0), 0.7);
        RandomStream stream(3, "test", "steps");
        for (int i = 0; i < 30; ++i) {
            update(c, d, draw_steps(c, d, stream), Eigen::VectorXd::Ones(5));
        }
        const auto text = save(d).dump();
        const nlohmann::json json = nlohmann::json::parse(text);
        const Distribution again = read_distribution(Reader(json, "state", ""), c);
        EXPECT_EQ(again.covariance, d.covariance);
        EXPECT_EQ(again.axes, d.axes);
        EXPECT_EQ(again.sigma, d.sigma);
        EXPECT_EQ(save(again).dump(), text);
    }
}

}  // namespace
}  // namespace k3d::optimizer::algorithm::cmaes
