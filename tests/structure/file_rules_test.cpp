// SPDX-License-Identifier: BSD-3-Clause
// What every file of the repository keeps to: licence line, sizes, no paths of one machine.
#include <gtest/gtest.h>

#include <regex>

#include "structure/source_tree.h"

namespace k3d::structure {
namespace {

constexpr std::size_t kMaxFileLines = 400;     // under
constexpr std::size_t kMaxFunctionLines = 60;  // under

bool is_source(const SourceFile& file) {
    return file.is_cpp() || file.is_page() || file.is_script();
}

TEST(FileRules, SourcesCarryTheLicenceLine) {
    for (const SourceFile& file : source_tree()) {
        if (!is_source(file)) continue;
        bool found = false;
        for (std::size_t i = 0; i < std::min<std::size_t>(3, file.lines.size()); ++i) {
            found = found || file.lines[i].find("SPDX-License-Identifier: BSD-3-Clause") !=
                                 std::string::npos;
        }
        EXPECT_TRUE(found) << file.path << " has no SPDX line at its top";
    }
}

TEST(FileRules, SourcesAreSmall) {
    for (const SourceFile& file : source_tree()) {
        if (is_source(file) || file.path.find("CMakeLists.txt") != std::string::npos) {
            EXPECT_LT(file.lines.size(), kMaxFileLines) << file.path;
        }
    }
}

struct Function {
    std::size_t line;    ///< of its first line, counted from 1
    std::size_t length;  ///< lines from the one that opens the body to the one that closes it
};

/// Function bodies at namespace level. As clang-format writes them, the line that opens one is not
/// indented or continues an indented parameter list, and the line that closes it is a lone "}".
std::vector<Function> functions_of(const SourceFile& file) {
    std::vector<Function> functions;
    std::size_t head = 0;  // the last unindented line, where a definition begins
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
        const std::string& line = file.lines[i];
        if (line.empty() || line[0] == '#' || line[0] == '/') continue;
        if (line[0] != ' ' && line[0] != '}') head = i;
        if (line == "}" && file.lines[head].rfind("namespace", 0) != 0) {
            functions.push_back({head + 1, i - head + 1});
        }
    }
    return functions;
}

TEST(FileRules, FunctionsAreMeasured) {
    const SourceFile file{"a.cpp",
                          {"namespace a {", "int one(int x,", "        int y) {", "    return x;",
                           "}", "int two() { return 2; }", "void three() {", "    if (a) {",
                           "    }", "", "}", "}  // namespace a"}};
    const std::vector<Function> functions = functions_of(file);
    ASSERT_EQ(functions.size(), 2u);
    EXPECT_EQ(functions[0].line, 2u);
    EXPECT_EQ(functions[0].length, 4u);
    EXPECT_EQ(functions[1].line, 7u);
    EXPECT_EQ(functions[1].length, 5u);
}

TEST(FileRules, FunctionsAreShort) {
    for (const SourceFile& file : source_tree()) {
        if (!file.is_cpp()) continue;
        for (const Function& function : functions_of(file)) {
            // A table of settings, one statement each, grows with what can be set.
            const std::string& head = file.lines[function.line - 1];
            if (head.find("::describe(config::Fields&") != std::string::npos) continue;
            EXPECT_LT(function.length, kMaxFunctionLines)
                << file.path << ":" << function.line << ": a function of " << function.length
                << " lines";
        }
    }
}

/// Read one function of each of these files, and you know the program.
const std::vector<std::string> kFlowFiles = {"server/cycle.cpp", "agent/think.cpp",
                                             "optimizer/daemon.cpp"};

TEST(FileRules, FlowFilesShowTheFlow) {
    for (const std::string& path : kFlowFiles) {
        const auto file = std::find_if(source_tree().begin(), source_tree().end(),
                                       [&path](const SourceFile& f) { return f.path == path; });
        ASSERT_NE(file, source_tree().end()) << path << " is missing";
        const std::vector<Function> functions = functions_of(*file);
        EXPECT_FALSE(functions.empty()) << path << " holds no function";
        for (const Function& function : functions) {
            EXPECT_LT(function.length, kMaxFunctionLines) << path << ":" << function.line;
        }
    }
}

TEST(FileRules, NoPathOfOneMachine) {
    const std::regex path(R"((^|[^A-Za-z0-9_.\-])/(work|home)/)");
    ASSERT_TRUE(std::regex_search(std::string("see /") + "work/file", path));
    ASSERT_FALSE(std::regex_search("common/network/file", path));
    for (const SourceFile& file : source_tree()) {
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            // An installed lock file's lines are long and machine-written; regex is slow on them.
            if (file.lines[i].size() > 1000 || file.lines[i].find('/') == std::string::npos)
                continue;
            EXPECT_FALSE(std::regex_search(file.lines[i], path))
                << file.path << ":" << i + 1 << ": " << file.lines[i];
        }
    }
}

TEST(FileRules, FilesNamedInDockerAreThere) {
    static const std::regex file(R"((optimizer|agent|server)/[A-Za-z0-9_./-]+\.(json|toml))");
    int count = 0;
    for (const SourceFile& source : source_tree()) {
        if (!source.below("docker")) continue;
        for (const std::string& line : source.lines) {
            for (std::sregex_iterator it(line.begin(), line.end(), file), end; it != end; ++it) {
                EXPECT_TRUE(std::filesystem::exists(K3D_SOURCE_DIR "/" + it->str()))
                    << source.path << " names " << it->str();
                ++count;
            }
        }
    }
    EXPECT_GE(count, 1) << "docker/play plays a learned network";
}

TEST(FileRules, TopLevelHoldsTheTreeAndNoMore) {
    const std::vector<std::string> allowed = {"CMakeLists.txt", "CMakePresets.json", "LICENSE",
                                              "README.md"};
    for (const SourceFile& file : source_tree()) {
        if (file.path.find('/') != std::string::npos || file.path[0] == '.') continue;
        EXPECT_NE(std::find(allowed.begin(), allowed.end(), file.path), allowed.end()) << file.path;
    }
}

}  // namespace
}  // namespace k3d::structure
