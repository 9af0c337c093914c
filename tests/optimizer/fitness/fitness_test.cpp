// SPDX-License-Identifier: BSD-3-Clause
// Fitness of matches and drills; what has none is no valid result.
#include "optimizer/fitness/fitness.h"

#include <gtest/gtest.h>

#include <cmath>

namespace k3d::optimizer::fitness {
namespace {

spec::TaskSpec task(const std::string& name, const std::string& figure = "") {
    spec::TaskSpec t;
    t.name = name;
    t.fitness = figure;
    return t;
}

k3d::episode::Result result() {
    k3d::episode::Result r;
    r.reason = "done";
    r.hold_time_s = 12.5;
    r.passes_completed = 3;
    r.attempts = 4;
    r.players = {{"left", 1, 2, 0.0, 0.0}, {"right", 1, 1, 0.0, 0.0}};
    r.metrics = {{"speed_mps", 0.7}, {"distance_m", 6.0}};
    return r;
}

TEST(Fitness, FiguresByName) {
    EXPECT_EQ(*fitness(task("keepaway"), result()), 12.5);
    EXPECT_EQ(*fitness(task("keepaway", "passes_completed"), result()), 3.0);
    EXPECT_EQ(*fitness(task("keepaway", "attempts"), result()), 4.0);
    EXPECT_EQ(*fitness(task("keepaway", "-falls"), result()), -3.0);
    EXPECT_EQ(*fitness(task("walk_forward", "speed_mps"), result()), 0.7);
}

TEST(Fitness, WhatIsMissingOrNotFiniteIsNamed) {
    EXPECT_EQ(fitness(task("keepaway", "goals"), result()).error(), "the result has no 'goals'");
    auto r = result();
    r.hold_time_s = std::nan("");
    EXPECT_EQ(fitness(task("keepaway"), r).error(), "'hold_time_s' is nan in the result");
    r.attempts.reset();
    EXPECT_FALSE(fitness(task("keepaway", "attempts"), r));
    r.metrics["speed_mps"] = INFINITY;
    EXPECT_FALSE(fitness(task("walk_forward"), r));
    EXPECT_FALSE(fitness(task("kick"), r));
}

TEST(Fitness, FallingFastDoesNotPay) {
    auto r = result();
    EXPECT_EQ(*fitness(task("walk_forward"), r), 0.7);
    r.reason = "fell";
    EXPECT_EQ(*fitness(task("walk_forward"), r), 0.2);
}

TEST(Fitness, OfTheOtherDrills) {
    auto r = result();
    r.metrics = {{"turn_deg_per_s", 90.0}, {"drift_m", 0.5}};
    EXPECT_NEAR(*fitness(task("walk_turn"), r), M_PI / 2 - 0.1, 1e-12);
    r.reason = "fell";
    EXPECT_EQ(*fitness(task("walk_turn"), r), 0.0);
    r.metrics = {{"speed_to_target_mps", 0.5}, {"falls_per_10_min", 2.0}};
    EXPECT_NEAR(*fitness(task("go_to"), r), 0.4, 1e-12);
    r.metrics = {{"fitness_capped", -1.0}, {"succeeded", 0.0}};
    EXPECT_EQ(*fitness(task("kick"), r), -1.0);
    EXPECT_EQ(*fitness(task("possession"), r), -30.0);
    r.metrics["time_to_kick_s"] = 7.5;
    EXPECT_EQ(*fitness(task("possession"), r), -7.5);
    r.metrics = {{"finish_loss", 0.25}};
    EXPECT_EQ(*fitness(task("ball_prediction"), r), -0.25);
}

TEST(Fitness, SimulatedTimeIsTheMetricIfThereIsOne) {
    auto r = result();
    EXPECT_EQ(simulated_s(r), 12.5);
    r.metrics["simulated_s"] = 14.0;
    EXPECT_EQ(simulated_s(r), 14.0);
}

}  // namespace
}  // namespace k3d::optimizer::fitness
