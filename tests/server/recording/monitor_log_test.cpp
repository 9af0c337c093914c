// SPDX-License-Identifier: BSD-3-Clause
// The monitor log: when frames are written, and which kind.
#include "server/recording/monitor_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "common/sexpr/writer.h"

namespace k3d::server::recording {
namespace {

std::string file_name() {
    return (std::filesystem::temp_directory_path() /
            ("k3d-monitor-log-test-" + std::to_string(getpid()) + ".log"))
        .string();
}

TEST(MonitorLog, FullFramesAtTheStartAndEveryThreeSeconds) {
    body::Scene scene;
    monitor::SceneGraph graph;
    graph.update(scene);
    {
        MonitorLog log(file_name(), {});
        for (Cycle now{5}; now.count <= 320; ++now) {
            monitor::GameView view;
            view.time = now.seconds();
            if (log.due(now)) log.add(now, graph, view);
        }
    }
    std::ifstream file(file_name());
    std::vector<std::string> kinds;
    std::string line;
    for (int i = 0; std::getline(file, line); ++i) {
        kinds.push_back(line.find("(RSG 0 1)") != std::string::npos ? "full" : "difference");
        // Cycles 10, 20, ...: a frame every 0.2 s.
        std::string time;
        sexpr::append_general(0.2 * (i + 1), time);
        EXPECT_NE(line.find("(time " + time + ")"), std::string::npos) << line.substr(0, 60);
    }
    ASSERT_EQ(kinds.size(), 32U);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        EXPECT_EQ(kinds[i], i % 15 == 0 ? "full" : "difference") << "line " << i;
    }
    std::filesystem::remove(file_name());
}

TEST(MonitorLog, AFileThatCannotBeWrittenIsNamed) {
    try {
        MonitorLog log("/no/such/folder/x.log", {});
        FAIL() << "no error";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(),
                     "cannot write monitor log /no/such/folder/x.log: No such file or directory");
    }
}

}  // namespace
}  // namespace k3d::server::recording
