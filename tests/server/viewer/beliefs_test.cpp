// SPDX-License-Identifier: BSD-3-Clause
// Tests of following agents' telemetry: the newest whole belief of each file, and nothing else.
#include "server/viewer/beliefs.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace k3d::server::viewer {
namespace {

namespace fs = std::filesystem;

class BeliefsTest : public testing::Test {
  protected:
    BeliefsTest() { fs::create_directories(folder_); }
    ~BeliefsTest() override { fs::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) {
        std::ofstream(folder_ / name, std::ios::app) << text;
    }
    static std::string belief(int time) {
        return R"({"time":)" + std::to_string(time) + R"(,"event":"belief"})";
    }

    const fs::path folder_ = fs::path(testing::TempDir()) / ("k3d_beliefs_" + std::to_string(getpid()));
    Beliefs beliefs_{folder_.string()};
};

TEST_F(BeliefsTest, TellsTheNewestBeliefOfEachOnce) {
    EXPECT_EQ(beliefs_.news(), "");
    write("keeper-1.telemetry.jsonl", R"({"time":0,"event":"start"})" "\n" + belief(1) + "\n" + belief(2) + "\n");
    write("keeper-2.telemetry.jsonl", belief(7) + "\n" R"({"time":8,"event":"fall"})" "\n");
    write("server.log", belief(9) + "\n");
    const auto told = nlohmann::json::parse(beliefs_.news());
    EXPECT_EQ(told["kind"], "beliefs");
    EXPECT_EQ(told["players"].size(), 2u);
    EXPECT_EQ(told["players"]["keeper-1"]["time"], 2);
    EXPECT_EQ(told["players"]["keeper-2"]["time"], 7);
    EXPECT_EQ(beliefs_.news(), "");
}

TEST_F(BeliefsTest, HalfALineWaitsForItsEnd) {
    const std::string line = belief(3) + "\n";
    write("a.telemetry.jsonl", line.substr(0, 12));
    EXPECT_EQ(beliefs_.news(), "");
    write("a.telemetry.jsonl", line.substr(12));
    EXPECT_EQ(nlohmann::json::parse(beliefs_.news())["players"]["a"]["time"], 3);
}

TEST_F(BeliefsTest, DamagedLinesAreSkipped) {
    write("a.telemetry.jsonl", "{\"event\":\"belief\"\n");
    EXPECT_EQ(beliefs_.news(), "");
    write("a.telemetry.jsonl", R"({"event":["belief"]})" "\n");
    EXPECT_EQ(beliefs_.news(), "");
    write("a.telemetry.jsonl", "\"belief\"" + std::string(200000, 'x') + "\n");
    EXPECT_EQ(beliefs_.news(), "");
    write("a.telemetry.jsonl", belief(4) + "\n");
    EXPECT_EQ(nlohmann::json::parse(beliefs_.news())["players"]["a"]["time"], 4);
}

TEST_F(BeliefsTest, AFileWrittenAnewOrRemoved) {
    write("a.telemetry.jsonl", belief(10) + "\n" + belief(11) + "\n");
    EXPECT_NE(beliefs_.news(), "");
    fs::remove(folder_ / "a.telemetry.jsonl");
    EXPECT_EQ(beliefs_.news(), "");
    write("a.telemetry.jsonl", belief(1) + "\n");
    EXPECT_EQ(nlohmann::json::parse(beliefs_.news())["players"]["a"]["time"], 1);
}

TEST(Beliefs, WithoutAFolderThereAreNone) {
    EXPECT_EQ(Beliefs("").news(), "");
    EXPECT_EQ(Beliefs("/nonexistent/folder").news(), "");
}

}  // namespace
}  // namespace k3d::server::viewer
