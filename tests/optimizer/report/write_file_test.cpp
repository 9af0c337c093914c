// SPDX-License-Identifier: BSD-3-Clause
// Files of a report: written anew, or named if they cannot be.
#include "optimizer/report/write_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace k3d::optimizer::report {
namespace {

TEST(WriteFile, ReplacesWhatWasThere) {
    const std::string path = testing::TempDir() + "k3d_write_" + std::to_string(::getpid());
    write_file(path, "the text before, which is longer\n");
    write_file(path, "a,b\r\n");
    std::ostringstream read;
    read << std::ifstream(path, std::ios::binary).rdbuf();
    EXPECT_EQ(read.str(), "a,b\r\n");
    std::filesystem::remove(path);
}

TEST(WriteFile, NamesAFileThatCannotBeWritten) {
    const std::string path = testing::TempDir() + "no/such/folder/report.html";
    EXPECT_THAT([&path] { write_file(path, "text"); },
                testing::ThrowsMessage<std::runtime_error>("cannot write " + path));
    EXPECT_THROW(write_file("/dev/full", "text"), std::runtime_error) << "a full disk";
}

}  // namespace
}  // namespace k3d::optimizer::report
