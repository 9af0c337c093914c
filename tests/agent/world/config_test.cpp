// SPDX-License-Identifier: BSD-3-Clause
// The shipped files of world and localisation say what the code's defaults say.
#include "agent/world/config.h"

#include <gtest/gtest.h>

#include "agent/localisation/config.h"
#include "common/config/config.h"

namespace k3d::agent::world {
namespace {

template <class Config>
void expect_file_equals_defaults(const std::string& file) {
    Config defaults;
    Config loaded;
    config::load_file(config::describing(loaded),
                      std::string(K3D_SOURCE_DIR) + "/agent/config/" + file);
    EXPECT_EQ(config::print(config::describing(loaded)),
              config::print(config::describing(defaults)));
}

TEST(SenseConfig, TheShippedFilesHoldTheDefaults) {
    expect_file_equals_defaults<WorldConfig>("world.toml");
    expect_file_equals_defaults<localisation::LocalisationConfig>("localisation.toml");
}

TEST(SenseConfig, FieldsHaveThePathsThatExperimentsName) {
    WorldConfig world;
    config::set(config::describing(world), "ball.alpha", "0.8");
    config::set(config::describing(world), "taker.lambda", "2.5");
    EXPECT_DOUBLE_EQ(world.ball.alpha, 0.8);
    EXPECT_DOUBLE_EQ(world.taker.lambda, 2.5);
    EXPECT_THROW(config::set(config::describing(world), "ball.alpha", "-1"), config::ConfigError);
}

}  // namespace
}  // namespace k3d::agent::world
