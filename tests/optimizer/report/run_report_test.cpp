// SPDX-License-Identifier: BSD-3-Clause
// What a champion says of where it comes from can be read again.
#include "optimizer/report/run_report.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "common/network/network.h"

namespace k3d::optimizer::report {
namespace {

TEST(Provenance, TellsTheCommandOfItsSearch) {
    const std::string folder = testing::TempDir() + "k3d_provenance_" + std::to_string(::getpid());
    std::filesystem::create_directories(folder);
    std::string head;
    {
        const auto ledger =
            ledger::Ledger::create(folder + "/l.sqlite", {{"id", "kick-4ca14eef"},
                                                          {"code_version", "0.1.0+x"},
                                                          {"command", "k3d-optimizer run"}});
        head = provenance_of(algorithm::Champion(), spec::Experiment(), ledger);
    }
    std::filesystem::remove_all(folder);
    EXPECT_EQ(command_in(head, "kick"), "k3d-optimizer run") << head;
    EXPECT_EQ(command_in("some/file.toml: " + head + "; tested by version 0.1.0+y", "kick"),
              "k3d-optimizer run");
    EXPECT_FALSE(command_in(head, "ick"));
    EXPECT_FALSE(command_in(head, "kick_early"));
    EXPECT_FALSE(command_in("", "kick"));
    EXPECT_FALSE(command_in("candidate 7 of run kick-4ca14eef, version 0.1.0+x", "kick"));
}

TEST(Provenance, OfPublishedRunsIsRead) {
    for (const char* run : {"1", "2", "3"}) {
        const auto file =
            std::string(K3D_SOURCE_DIR "/optimizer/experiments/results/keepaway_linear-") + run +
            ".json";
        EXPECT_EQ(command_in(network::load_file(file).description, "keepaway_linear"),
                  "k3d-optimizer reproduce table1 --budget paper")
            << file;
    }
}

}  // namespace
}  // namespace k3d::optimizer::report
