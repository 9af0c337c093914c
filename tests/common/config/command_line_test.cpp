// SPDX-License-Identifier: BSD-3-Clause
// What all programs' command lines have in common: --help, exit codes, standard streams.
#include "common/config/command_line.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>

namespace k3d::config {
namespace {

using ::testing::ContainsRegex;

struct Settings {
    int port = 3100;
    double patience = 30.0;
    std::string name;

    void describe(Fields& f) {
        f.integer("port", port, {0, 65535}, "", "where");
        f.number("patience", patience, {0, 100}, "s", "how long");
        f.text("name", name, {}, "who");
    }
};

const std::vector<ShortFlag> kFlags{{"--port", "port", "a port"},
                                    {"--patience-s", "patience", "seconds"},
                                    {"--name", "name", "a name"}};

int run_with(CLI::App& app, std::vector<std::string> words, const std::function<int()>& run) {
    words.insert(words.begin(), "program");
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    return run_program(app, static_cast<int>(arguments.size()), arguments.data(), "program", run);
}

TEST(CommandLine, HelpShowsWhatTheConfigurationHas) {
    CLI::App app;
    CommandLine line;
    Settings settings;
    add_flags(app, line, kFlags, "port=1", describing(settings));
    EXPECT_THAT(app.help(), ContainsRegex("--port TEXT[^\n]*3100[^\n]* a port"));
    EXPECT_THAT(app.help(), ContainsRegex("--patience-s TEXT[^\n]*30.0"));
    EXPECT_THAT(app.help(), ContainsRegex("--name TEXT +a name"));
    EXPECT_EQ(run_with(app, {"--name", "x"}, [] { return 0; }), 0);
    EXPECT_EQ(line.settings.size(), 1U) << "what only help shows is not set";
}

TEST(CommandLine, FailuresAreExitCodes) {
    const auto code = [](const std::vector<std::string>& words, const std::function<int()>& run) {
        CLI::App app;
        return run_with(app, words, run);
    };
    EXPECT_EQ(code({}, [] { return 7; }), 7);
    EXPECT_EQ(code({"--unknown"}, [] { return 7; }), kExitUsage);
    EXPECT_EQ(code({}, []() -> int { throw ConfigError("bad"); }), kExitUsage);
    EXPECT_EQ(code({}, []() -> int { throw std::invalid_argument("bad"); }), kExitUsage);
    EXPECT_EQ(code({}, []() -> int { throw std::runtime_error("bad"); }), kExitFailed);
}

TEST(CommandLine, NoFileTakesTheNumberOfAClosedStandardStream) {
    const auto number_of_the_first_file = [] {
        for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::close(fd);
        CLI::App app;
        std::exit(run_with(app, {}, [] { return ::open("/dev/null", O_RDONLY); }));
    };
    EXPECT_EXIT(
        number_of_the_first_file(),
        [](int status) { return WIFEXITED(status) && WEXITSTATUS(status) > STDERR_FILENO; }, "");
}

}  // namespace
}  // namespace k3d::config
