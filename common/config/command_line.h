// SPDX-License-Identifier: BSD-3-Clause
// What the programs' command lines have in common: TOML files, single settings, short flags for
// configuration paths, and how every failure becomes one line and an exit code.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "common/config/config.h"

namespace CLI {
class App;
}

namespace k3d::config {

inline constexpr int kExitFailed = 1;  ///< a port, a file, a connection or a child failed
inline constexpr int kExitUsage = 2;   ///< the command line, a configuration or what it names is bad
inline constexpr int kExitInterrupted = 130;  ///< stopped by the user, as a shell says of Ctrl-C

/// A flag that is the short name of a configuration path: {"--pace", "pace.mode", "help"}.
using ShortFlag = std::array<const char*, 3>;

/// What a command line asks for. Flags win over files and --set over flags, wherever they stand; of
/// several files, and of several --set, the later wins.
struct CommandLine {
    std::vector<std::string> files;
    std::vector<std::pair<std::string, std::string>> settings;  ///< path, value
    std::string log_level = "info";
    bool print_config = false;
    bool print_fields = false;
};

/// Adds `flags` and --config, --set, --print-config, --print-fields, --log-level. `example` is
/// shown with --set; --help shows the values that `defaults` has at the flags' paths. Options are
/// carried out in the order in which they are added: whoever adds further flags that set something
/// must do so before.
void add_flags(CLI::App& app, CommandLine& line, const std::vector<ShortFlag>& flags,
               const std::string& example, const Describe& defaults = {});

/// Loads the files and sets the settings. Throws ConfigError.
void resolve(const CommandLine& line, const Describe& describe);
/// Prints what --print-config or --print-fields asks for; false if neither was given.
bool print_wanted(const CommandLine& line, const Describe& describe);

/// Parses and runs; a failure is printed as one line with the program's name. Standard streams that
/// are closed become /dev/null. Returns the exit code: run()'s, kExitUsage for ConfigError and
/// std::invalid_argument, kExitFailed for the rest.
int run_program(CLI::App& app, int argc, char** argv, const std::string& program,
                const std::function<int()>& run);

}  // namespace k3d::config
