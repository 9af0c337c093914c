// SPDX-License-Identifier: BSD-3-Clause
// Attempts from telemetry, and telemetry that is none.
#include "optimizer/episode/telemetry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace k3d::optimizer::episode {
namespace {

using testing::HasSubstr;

class TelemetryTest : public testing::Test {
  protected:
    ~TelemetryTest() override { std::filesystem::remove(path_); }

    int count(const std::string& text) {
        std::ofstream(path_) << text;
        return count_attempts(path_);
    }

    std::string error(const std::string& text) {
        try {
            count(text);
        } catch (const TelemetryError& error) {
            return error.what();
        }
        return "no error";
    }

    std::string path_ = testing::TempDir() + "k3d_telemetry_" + std::to_string(::getpid());
};

TEST_F(TelemetryTest, CountsKickAttemptsOnly) {
    EXPECT_EQ(count(""), 0);
    EXPECT_EQ(count("{\"time\": 1.0, \"event\": \"kick_attempt\", \"mode\": \"pass\"}\n"
                    "{\"time\": 1.02, \"pose\": [1, 2, 3]}\n"
                    "{\"time\": 1.5, \"event\": \"fall\"}\n"
                    "{\"time\": 2, \"event\": \"kick_attempt\"}\n"
                    "{\"time\": 3, \"event\": 7}\n"),
              2);
}

TEST_F(TelemetryTest, ABadLineIsNamed) {
    EXPECT_EQ(error("{\"time\": 1}\nnonsense\n"), path_ + ":2: not a JSON object");
    EXPECT_EQ(error("{\"event\": \"kick_attempt\"}\n"), path_ + ":1: no numeric 'time'");
    EXPECT_EQ(error("{\"time\": \"1\"}\n"), path_ + ":1: no numeric 'time'");
    EXPECT_EQ(error("{\"time\": 1}\n{\"time\": 2}"), path_ + ":2: the line has no end");
}

TEST_F(TelemetryTest, AMissingFileIsNamed) {
    try {
        count_attempts("/nowhere/telemetry");
        ADD_FAILURE();
    } catch (const TelemetryError& error) {
        EXPECT_STREQ(error.what(), "no telemetry: /nowhere/telemetry");
    }
}

}  // namespace
}  // namespace k3d::optimizer::episode
