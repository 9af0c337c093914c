// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/report/drill_table.h"

#include <gmock/gmock.h>

namespace k3d::optimizer::report {
namespace {

using testing::HasSubstr;

TEST(DrillTable, EachMetricOverTheRunsThatHaveIt) {
    spec::DrillSpec spec;
    spec.name = "kick";
    spec.runs = 4;
    spec.seed = 7;
    std::vector<k3d::episode::Result> results(3);
    results[0].reason = results[1].reason = "done";
    results[2].reason = "no_kick";
    results[0].metrics = {{"distance_m", 4.0}, {"succeeded", 1.0}};
    results[1].metrics = {{"distance_m", 6.0}, {"succeeded", 1.0}};
    results[2].metrics = {{"succeeded", 0.0}};
    const std::string text = drill_table(spec, results);
    EXPECT_THAT(text, HasSubstr("drill kick, type 0, seeds 7 to 10\n"));
    EXPECT_THAT(text, HasSubstr("distance_m                      2     5.000     1.414     1.000"
                                "     4.100     5.000     5.900\n"));
    EXPECT_THAT(text, HasSubstr("succeeded                       3     0.667"));
    EXPECT_THAT(text, HasSubstr("ended by: done 2 no_kick 1\n"));
    EXPECT_THAT(text, HasSubstr("runs with a valid result: 3 of 4\n"));
}

TEST(DrillTable, RunsThatCountAsPlayedBeforeHaveTheFirstSeeds) {
    spec::DrillSpec spec;
    spec.seed = 7;
    spec.first = 3;
    spec.runs = 2;
    EXPECT_THAT(drill_table(spec, {}), HasSubstr("seeds 10 to 11\n"));
}

TEST(DrillTable, NoRunsNoRows) {
    EXPECT_THAT(drill_table({}, {}), HasSubstr("ended by:\nruns with a valid result: 0 of 10\n"));
}

}  // namespace
}  // namespace k3d::optimizer::report
