// SPDX-License-Identifier: BSD-3-Clause
// What CMA-ES must not notice: rotations, monotone transformations of fitness, translations.
#include <gtest/gtest.h>

#include <Eigen/QR>

#include "common/random/stream.h"
#include "optimizer/algorithm/functions.h"

namespace k3d::optimizer::algorithm {
namespace {

using testing::Values;

/// A random orthogonal matrix.
Eigen::MatrixXd rotation(int n) {
    RandomStream stream(1, "test", "rotation");
    Eigen::MatrixXd m(n, n);
    for (double& v : m.reshaped()) v = stream.normal();
    return Eigen::HouseholderQR<Eigen::MatrixXd>(m).householderQ();
}

double median_evaluations(const testing::Function& f, bool active, const std::string& covariance) {
    std::vector<double> evaluations;
    for (std::uint64_t seed = 1; seed <= 15; ++seed) {
        spec::AlgorithmSpec spec;
        spec.cmaes.active = active;
        spec.cmaes.covariance = covariance;
        Algorithm algorithm(spec, testing::box(10, 3.0, 2.0), seed);
        evaluations.push_back(testing::minimise(algorithm, f, 1e-9, 3e4).evaluations);
    }
    return testing::median(evaluations);
}

const testing::Function kEllipsoid = [](const Values& x) { return testing::ellipsoid(x); };

TEST(CmaesInvariance, RotatedEllipsoidCostsTheSame) {
    const Eigen::MatrixXd q = rotation(10);
    const testing::Function rotated = [&q](const Values& x) {
        const Eigen::VectorXd y = q * Eigen::Map<const Eigen::VectorXd>(x.data(), 10);
        return testing::ellipsoid(Values(y.data(), y.data() + 10));
    };
    for (const bool active : {true, false}) {
        const double straight = median_evaluations(kEllipsoid, active, "full");
        EXPECT_NEAR(median_evaluations(rotated, active, "full"), straight, 0.12 * straight);
    }
    // The separable variant has what it needs on the axes, learns it faster, and is lost elsewhere.
    EXPECT_LT(median_evaluations(kEllipsoid, true, "separable"),
              0.9 * median_evaluations(kEllipsoid, true, "full"));
    EXPECT_EQ(median_evaluations(rotated, true, "separable"), 3e4);
}

/// Best value of each generation, as f sees it; the search gets g(f).
std::vector<Values> trace(const testing::Function& f, const std::function<double(double)>& g,
                          double start, int generations) {
    Algorithm algorithm({}, testing::box(8, start, 1.0), 5);
    std::vector<Values> points;
    for (int i = 0; i < generations; ++i) {
        for (const Request& request : algorithm.ask()) {
            points.push_back(std::get<Values>(request.payload));
            algorithm.tell(request.candidate, request.pool, {-g(f(points.back())), 0.0, 1});
        }
        algorithm.advance();
    }
    return points;
}

TEST(CmaesInvariance, OnlyRanksCount) {
    const auto plain = trace(testing::rosenbrock, [](double v) { return v; }, 0.0, 150);
    EXPECT_EQ(trace(testing::rosenbrock, [](double v) { return v * v * v; }, 0.0, 150), plain);
    EXPECT_EQ(trace(testing::rosenbrock, [](double v) { return -1.0 / (1.0 + v); }, 0.0, 150), plain);
}

TEST(CmaesInvariance, TranslationShiftsThePath) {
    constexpr double kShift = 1024.0;
    const auto same = [](double v) { return v; };
    const auto here = trace(testing::rosenbrock, same, 0.0, 60);
    const auto there = trace(
        [](Values x) {
            for (double& v : x) v -= kShift;
            return testing::rosenbrock(x);
        },
        same, kShift, 60);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t i = 0; i < here.size(); ++i) {
        for (std::size_t k = 0; k < here[i].size(); ++k) {
            ASSERT_NEAR(there[i][k] - kShift, here[i][k], 1e-6) << "candidate " << i;
        }
    }
}

TEST(CmaesInvariance, StepSizeFallsInStepWithTheDistanceOnTheSphere) {
    Algorithm algorithm({}, testing::box(10, 3.0, 2.0), 3);
    testing::minimise(algorithm, testing::sphere, 1e-16, 1e5);
    std::vector<double> logarithms;
    for (const auto& line : algorithm.take_log()) {
        logarithms.push_back(std::log10(line["sigma"].get<double>()));
    }
    // Linear convergence: the second half of the run falls as fast as the first, within a third.
    const std::size_t half = logarithms.size() / 2;
    const double first = logarithms.front() - logarithms[half];
    const double second = logarithms[half] - logarithms.back();
    EXPECT_GT(first, 3.0);
    EXPECT_NEAR(second / first, 1.0, 0.34);
}

TEST(CmaesInvariance, ActiveSavesAFifthOnTheEllipsoid) {
    const auto spent = [](bool active) {
        std::vector<double> evaluations;
        for (std::uint64_t seed = 1; seed <= 15; ++seed) {
            spec::AlgorithmSpec spec;
            spec.cmaes.active = active;
            Algorithm algorithm(spec, testing::box(20, 3.0, 2.0), seed);
            evaluations.push_back(testing::minimise(algorithm, kEllipsoid, 1e-9, 1e5).evaluations);
        }
        return testing::median(evaluations);
    };
    EXPECT_LE(spent(true), 0.8 * spent(false));
}

}  // namespace
}  // namespace k3d::optimizer::algorithm
