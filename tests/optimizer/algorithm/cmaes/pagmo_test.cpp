// SPDX-License-Identifier: BSD-3-Clause
// pagmo's CMA-ES as the judge of ours: the same functions, starts, step sizes and populations. pagmo
// has no negative weights and no restarts, so the plain variant stands trial.
#include <gtest/gtest.h>

#if __has_include(<pagmo/algorithms/cmaes.hpp>)

#include <iostream>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

#include "optimizer/algorithm/cmaes/distribution.h"
#include "optimizer/algorithm/functions.h"

namespace k3d::optimizer::algorithm {
namespace {

using testing::Values;

constexpr double kTarget = 1e-9;
constexpr double kWidth = 128.0;  // pagmo measures its step size in widths of the box

struct Judged {
    std::string name;
    testing::Function f;
    int n;
    double start;
    double deviation;
};

/// A problem as pagmo wants it, which remembers when the target was first met.
struct Counted {
    testing::Function f;
    int n = 1;
    double start = 0.0;
    mutable double evaluations = 0.0;
    mutable bool reached = false;

    Values fitness(const Values& x) const {
        const double value = f(x);
        if (!reached) evaluations += 1.0;
        reached = reached || value <= kTarget;
        return {value};
    }
    std::pair<Values, Values> get_bounds() const {
        const auto size = static_cast<std::size_t>(n);
        return {Values(size, start - kWidth / 2), Values(size, start + kWidth / 2)};
    }
};

double pagmo_evaluations(const Judged& j, unsigned seed) {
    pagmo::problem problem{Counted{j.f, j.n, j.start}};
    pagmo::population population(problem, 0U, seed);
    const int size = cmaes::default_population(j.n);
    for (int i = 0; i < size; ++i) {
        population.push_back(Values(static_cast<std::size_t>(j.n), j.start));
    }
    const auto* counted = population.get_problem().extract<Counted>();
    const double before = counted->evaluations;  // of the starting population
    pagmo::algorithm cma{
        pagmo::cmaes(50U, -1, -1, -1, -1, j.deviation / kWidth, 0.0, 0.0, true, false, seed)};
    while (!counted->reached && counted->evaluations < 1e5) {
        population = cma.evolve(population);
        counted = population.get_problem().extract<Counted>();
    }
    return counted->evaluations - before;
}

class Judge : public ::testing::TestWithParam<Judged> {};

TEST_P(Judge, AgreesWithinTwelvePerCent) {
    const Judged& j = GetParam();
    std::vector<double> ours;
    std::vector<double> theirs;
    for (unsigned seed = 1; seed <= 15; ++seed) {
        spec::AlgorithmSpec spec;
        spec.cmaes.active = false;
        Algorithm algorithm(spec, testing::box(j.n, j.start, j.deviation), seed);
        const testing::Run run = testing::minimise(algorithm, j.f, kTarget, 1e5);
        if (run.reached) ours.push_back(run.evaluations);
        const double judged = pagmo_evaluations(j, seed);
        if (judged < 1e5) theirs.push_back(judged);
    }
    ASSERT_GE(ours.size(), 10u);
    ASSERT_GE(theirs.size(), 10u);
    std::cout << j.name << ": ours " << testing::median(ours) << ", pagmo "
              << testing::median(theirs) << " evaluations\n";
    EXPECT_NEAR(testing::median(ours) / testing::median(theirs), 1.0, 0.12);
}

INSTANTIATE_TEST_SUITE_P(
    Cmaes, Judge,
    ::testing::Values(
        Judged{"sphere_10", testing::sphere, 10, 3.0, 2.0},
        Judged{"sphere_20", testing::sphere, 20, 3.0, 2.0},
        Judged{"ellipsoid_10", [](const Values& x) { return testing::ellipsoid(x); }, 10, 3.0, 2.0},
        Judged{"rosenbrock_10", testing::rosenbrock, 10, 0.0, 0.5}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace k3d::optimizer::algorithm

#else

TEST(Judge, NeedsPagmo) { GTEST_SKIP() << "libpagmo-dev is not installed"; }

#endif
