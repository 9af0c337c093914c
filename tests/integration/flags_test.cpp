// SPDX-License-Identifier: BSD-3-Clause
// Which of several flags that set the same thing holds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "integration/server_process.h"

namespace k3d::testing {
namespace {

using ::testing::HasSubstr;

/// What k3d-server makes of these flags.
std::string configured(std::vector<std::string> flags) {
    flags.push_back("--print-config");
    const auto [code, text] = run_to_end("k3d-server", flags);
    EXPECT_EQ(code, 0) << text;
    return text;
}

TEST(Flags, SetWinsOverFlagsWhereverItStands) {
    for (const std::vector<std::string>& flags : std::vector<std::vector<std::string>>{
             {"--noise", "off", "--set", "vision.noise=true"},
             {"--set", "vision.noise=true", "--noise", "off"}}) {
        EXPECT_THAT(configured(flags), HasSubstr("\nnoise = true"));
    }
    EXPECT_THAT(configured({"--ground-truth", "--set", "vision.my_position=false"}),
                HasSubstr("\nmy_position = false"));
    EXPECT_THAT(configured({"--set", "seed=4", "--set", "seed=5", "--seed", "3"}),
                HasSubstr("seed = 5  #"));
}

TEST(Flags, WinOverFiles) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("k3d-flags-" + std::to_string(getpid()) + ".toml");
    std::ofstream(file) << "seed = 4\n[vision]\nnoise = true\nmy_position = true\n";
    const std::string text = configured({"--noise", "off", "--config", file.string()});
    EXPECT_THAT(text, HasSubstr("\nnoise = false"));
    EXPECT_THAT(text, HasSubstr("\nmy_position = true"));
    EXPECT_THAT(text, HasSubstr("seed = 4  #"));
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace k3d::testing
