// SPDX-License-Identifier: BSD-3-Clause
// The task of an experiment.
#include "optimizer/spec/task_spec.h"

#include <gtest/gtest.h>

namespace k3d::optimizer::spec {
namespace {

TEST(Task, TakersOfBothKindsComeInTurn) {
    TaskSpec task;
    task.taker = "both";
    EXPECT_EQ(taker_of(task, 0), "greedy");
    EXPECT_EQ(taker_of(task, 1), "greedy_random");
    EXPECT_EQ(taker_of(task, 2), "greedy");
    task.taker = "greedy_random";
    EXPECT_EQ(taker_of(task, 0), "greedy_random");
}

}  // namespace
}  // namespace k3d::optimizer::spec
