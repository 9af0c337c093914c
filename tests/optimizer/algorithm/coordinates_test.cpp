// SPDX-License-Identifier: BSD-3-Clause
// Tests of optimizer/algorithm/coordinates: the smooth map into bounds, and which parameters are refused.
#include "optimizer/algorithm/coordinates.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "optimizer/algorithm/error.h"

namespace k3d::optimizer::algorithm {
namespace {

using ::testing::HasSubstr;

constexpr double kInf = std::numeric_limits<double>::infinity();

spec::Parameter parameter(double start, double deviation, double lower, double upper) {
    return {"p", start, deviation, lower, upper, false, false};
}

RC_GTEST_PROP(IntoBounds, StaysWithinAndFindsItsWayBack, ()) {
    const double lower = *rc::gen::inRange(-1000, 1000) * 0.01;
    const double upper = lower + *rc::gen::inRange(1, 1000) * 0.01;
    const double u = *rc::gen::inRange(-100000, 100000) * 0.001;
    const double x = into_bounds(u, lower, upper, 1.0);
    RC_ASSERT(x >= lower);
    RC_ASSERT(x <= upper);
    const double back = out_of_bounds(x, lower, upper, 1.0);
    RC_ASSERT(std::abs(into_bounds(back, lower, upper, 1.0) - x) < 1e-9);
    const double above = into_bounds(u, lower, kInf, 0.5);
    RC_ASSERT(above >= lower);
    const double below = into_bounds(u, -kInf, upper, 0.5);
    RC_ASSERT(below <= upper);
}

TEST(IntoBounds, IsTheIdentityInsideAndSmoothAtTheEdge) {
    EXPECT_EQ(into_bounds(0.5, 0.0, 1.0, 1.0), 0.5);
    EXPECT_EQ(into_bounds(123.0, -kInf, kInf, 1.0), 123.0);
    // Slopes on either side of the margin's begin and of the bound agree.
    const double h = 1e-6;
    for (const double u : {0.05, -0.05, 0.95, 1.05}) {
        const double left = (into_bounds(u, 0.0, 1.0, 1.0) - into_bounds(u - h, 0.0, 1.0, 1.0)) / h;
        const double right = (into_bounds(u + h, 0.0, 1.0, 1.0) - into_bounds(u, 0.0, 1.0, 1.0)) / h;
        EXPECT_NEAR(left, right, 1e-4) << u;
    }
    // Two points outside stay two points: nothing piles up on the bound.
    EXPECT_NE(into_bounds(-0.1, 0.0, 1.0, 1.0), into_bounds(-0.2, 0.0, 1.0, 1.0));
}

TEST(Coordinates, StartComesBackFromTheSearchSpace) {
    std::vector<spec::Parameter> list{parameter(0.3, 0.1, 0.0, 1.0), parameter(0.0, 2.0, 0.0, 5.0),
                                      parameter(7.0, 3.0, -kInf, kInf), parameter(1.0, 1.0, -kInf, 1.0)};
    for (std::size_t i = 0; i < list.size(); ++i) list[i].name = std::string(i + 1, 'p');
    const Coordinates space(list);
    const std::vector<double> values = space.values(space.start());
    EXPECT_NEAR(values[0], 0.3, 1e-12);
    EXPECT_NEAR(values[1], 0.0, 1e-12);
    EXPECT_NEAR(values[2], 7.0, 1e-12);
    EXPECT_NEAR(values[3], 1.0, 1e-12);
    Eigen::VectorXd point = space.start();
    point[2] += 1.0;  // one first deviation
    EXPECT_NEAR(space.values(point)[2], 10.0, 1e-12);
}

TEST(Coordinates, FrozenParametersAreNoCoordinatesAndWholeOnesAreRounded) {
    std::vector<spec::Parameter> list(3, parameter(2.0, 1.0, -kInf, kInf));
    list[0].name = "frozen";
    list[0].frozen = true;
    list[1].name = "whole";
    list[1].integer = true;
    list[1].lower = 0.5;
    list[1].upper = 4.5;
    const Coordinates space(list);
    ASSERT_EQ(space.dimension(), 2);
    EXPECT_EQ(space.least_deviation()[0], 0.25);
    EXPECT_EQ(space.least_deviation()[1], 0.0);
    RandomStream stream(1, "test", "points");
    for (int i = 0; i < 1000; ++i) {
        const auto values = space.values(Eigen::Vector2d(3.0 * stream.normal(), stream.normal()));
        EXPECT_EQ(values[0], 2.0);
        EXPECT_EQ(values[1], std::round(values[1]));
        EXPECT_GE(values[1], 1.0);
        EXPECT_LE(values[1], 4.0);
    }
}

TEST(Coordinates, WhatMakesNoSenseIsNamed) {
    const auto error = [](spec::Parameter p) -> std::string {
        try {
            Coordinates space({std::move(p)});
        } catch (const AlgorithmError& e) {
            return e.what();
        }
        return "no error";
    };
    EXPECT_EQ(error(parameter(0.0, 1.0, -1.0, 1.0)), "no error");
    EXPECT_THAT(error(parameter(0.0, 1.0, 1.0, -1.0)), HasSubstr("\"p\": lower bound 1 is not below"));
    EXPECT_THAT(error(parameter(2.0, 1.0, -1.0, 1.0)), HasSubstr("start 2 is outside its bounds -1 to 1"));
    EXPECT_THAT(error(parameter(0.0, 0.0, -1.0, 1.0)), HasSubstr("deviation 0 is not above 0"));
    EXPECT_THAT(error(parameter(0.0, -kInf, -1.0, 1.0)), HasSubstr("deviation -inf"));
    EXPECT_THAT(error(parameter(std::nan(""), 1.0, -1.0, 1.0)), HasSubstr("start nan"));
    EXPECT_THAT(error(parameter(0.0, 1.0, std::nan(""), 1.0)), HasSubstr("bound is not a number"));
    EXPECT_THAT(error({"p", 0.5, 1.0, 0.2, 0.8, true, false}), HasSubstr("no whole number"));
    EXPECT_THAT(error({"p", 0.5, 1.0, 0.0, 0.8, true, true}), HasSubstr("0.5 is not a whole number"));
    EXPECT_THAT(error({"", 0.5, 1.0, 0.2, 0.8, false, false}), HasSubstr("empty name"));
    EXPECT_THAT(error({"p", 0.5, 1.0, 0.2, 0.8, false, true}), HasSubstr("all frozen"));
    const spec::Parameter p = parameter(0.0, 1.0, -1.0, 1.0);
    EXPECT_THROW(Coordinates({p, p}), AlgorithmError);
}

}  // namespace
}  // namespace k3d::optimizer::algorithm
