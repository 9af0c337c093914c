// SPDX-License-Identifier: BSD-3-Clause
// The files in agent/config/, as --config takes them: each tells every setting of its section, with
// the value that the code has too.
#include "agent/config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "common/config/config.h"

namespace k3d::agent {
namespace {

const std::filesystem::path kFolder = K3D_SOURCE_DIR "/agent/config";
const std::map<std::string, std::string> kSections{
    {"getup.toml", "motion.getup."},
    {"kick.toml", "motion.kick."},
    {"kick_by_type.toml", "motion.kick_by_type."},
    {"localisation.toml", "localisation."},
    {"walk.toml", "motion.walk."},
    {"world.toml", "world."},
};

/// What stands before the first "=" of each, of those that begin with `section`.
std::vector<std::string> paths_of(const std::vector<std::string>& assignments,
                                  const std::string& section = "") {
    std::vector<std::string> paths;
    for (const std::string& text : assignments) {
        if (text.starts_with(section)) paths.push_back(text.substr(0, text.find('=')));
    }
    return paths;
}

TEST(AgentConfig, TheFilesTellTheDefaultsAllOfThemAndNoMore) {
    Config defaults;
    const std::string printed = config::print(config::describing(defaults));
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
        SCOPED_TRACE(entry.path().filename());
        const std::string& section = kSections.at(entry.path().filename());
        EXPECT_THAT(paths_of(config::assignments_of_file(entry.path())),
                    testing::UnorderedElementsAreArray(
                        paths_of(config::assignments(printed, "defaults"), section)));
        Config loaded;
        config::load_file(config::describing(loaded), entry.path());
        EXPECT_EQ(config::print(config::describing(loaded)), printed);
        ++files;
    }
    EXPECT_EQ(files, static_cast<int>(kSections.size()));
}

}  // namespace
}  // namespace k3d::agent
