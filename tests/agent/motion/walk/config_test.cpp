// SPDX-License-Identifier: BSD-3-Clause
#include "agent/motion/walk/config.h"

#include <gtest/gtest.h>

#include "common/config/config.h"

namespace k3d::agent::motion::walk {
namespace {

TEST(WalkConfig, FileHoldsTheDefaults) {
    Config loaded;
    config::load_file(config::describing(loaded), K3D_SOURCE_DIR "/agent/config/walk.toml");
    Config defaults;
    EXPECT_EQ(config::print(config::describing(loaded)), config::print(config::describing(defaults)));
}

TEST(WalkConfig, FileNamesEveryField) {
    // Other values in every field the file might leave out would show.
    Config loaded;
    config::set(config::describing(loaded), "step_height", "0.05");
    config::set(config::describing(loaded), "elbow", "0.1");
    config::set(config::describing(loaded), "max_forward", "0.1");
    config::load_file(config::describing(loaded), K3D_SOURCE_DIR "/agent/config/walk.toml");
    Config defaults;
    EXPECT_EQ(config::print(config::describing(loaded)), config::print(config::describing(defaults)));
}

}  // namespace
}  // namespace k3d::agent::motion::walk
