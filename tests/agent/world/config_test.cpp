// SPDX-License-Identifier: BSD-3-Clause
// Paths of settings of the world model.
#include "agent/world/config.h"

#include <gtest/gtest.h>

#include "common/config/config.h"

namespace k3d::agent::world {
namespace {

TEST(WorldConfig, FieldsHaveThePathsThatExperimentsName) {
    WorldConfig world;
    config::set(config::describing(world), "ball.alpha", "0.8");
    config::set(config::describing(world), "taker.lambda", "2.5");
    EXPECT_DOUBLE_EQ(world.ball.alpha, 0.8);
    EXPECT_DOUBLE_EQ(world.taker.lambda, 2.5);
    EXPECT_THROW(config::set(config::describing(world), "ball.alpha", "-1"), config::ConfigError);
}

}  // namespace
}  // namespace k3d::agent::world
