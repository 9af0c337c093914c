// SPDX-License-Identifier: BSD-3-Clause
// Log lines, levels, and the end of a program whose assumption broke.
#include "common/log/log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace k3d::log {
namespace {

/// Leaves the level as other tests expect it.
struct LogStart : testing::Test {
    ~LogStart() override { start("tests", "warning"); }
};

TEST_F(LogStart, LineNamesProgramAndLevel) {
    testing::internal::CaptureStderr();
    start("k3d-server", "info");
    spdlog::info("listening on {}", 3100);
    spdlog::debug("not shown");
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_THAT(text, testing::MatchesRegex("k3d-server [0-9:.]+ info: listening on 3100\n"));
}

TEST_F(LogStart, OffIsSilent) {
    testing::internal::CaptureStderr();
    start("k3d-server", "off");
    spdlog::error("not shown");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(LogStart, UnknownLevelIsNamed) {
    try {
        start("k3d-server", "loud");
        FAIL() << "level loud was accepted";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(),
                     "log level \"loud\" is none of trace, debug, info, warning, error, off");
    }
}

TEST(AssertDeathTest, SaysWhereAndWhat) {
    const int one = 1;
    K3D_ASSERT(one == 1);
    EXPECT_DEATH(K3D_ASSERT(one == 2), "log_test.cpp:[0-9]+: broken assumption: one == 2");
}

}  // namespace
}  // namespace k3d::log
