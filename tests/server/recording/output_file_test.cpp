// SPDX-License-Identifier: BSD-3-Clause
// Files a run writes: what is added, what is begun anew, and what cannot be written.
#include "server/recording/output_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <sstream>

namespace k3d::server::recording {
namespace {

using Begin = OutputFile::Begin;

std::string fault(const std::string& file, bool write) {
    try {
        OutputFile out("results", file, Begin::BehindWhatIsThere);
        if (write) out.write("a line\n");
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "none";
}

TEST(OutputFile, IsAddedToOrBegunAnew) {
    const std::string file = (std::filesystem::temp_directory_path() /
                              ("k3d-output-file-test-" + std::to_string(getpid())))
                                 .string();
    const auto content = [&file] {
        std::stringstream text;
        text << std::ifstream(file).rdbuf();
        return text.str();
    };
    std::filesystem::remove(file);
    OutputFile first("lines", file, Begin::BehindWhatIsThere);
    first.write("1\n");
    EXPECT_EQ(content(), "1\n") << "it is out at once";
    OutputFile("lines", file, Begin::BehindWhatIsThere).write("2\n");
    EXPECT_EQ(content(), "1\n2\n");
    OutputFile("lines", file, Begin::Anew).write("3\n");
    EXPECT_EQ(content(), "3\n");
    std::filesystem::remove(file);
}

TEST(OutputFile, SaysWhichFileCannotBeWrittenAndWhy) {
    EXPECT_EQ(fault("/no/such/folder/x.jsonl", false),
              "cannot write results to /no/such/folder/x.jsonl: No such file or directory");
    EXPECT_EQ(fault("/dev/full", false), "none");
    EXPECT_EQ(fault("/dev/full", true),
              "cannot write results to /dev/full: No space left on device");
}

}  // namespace
}  // namespace k3d::server::recording
