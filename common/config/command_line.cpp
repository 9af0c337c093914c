// SPDX-License-Identifier: BSD-3-Clause
#include "common/config/command_line.h"

#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "common/config/text.h"
#include "common/config/walk.h"

namespace k3d::config {

namespace {

std::pair<std::string, std::string> path_and_value(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos) {
        throw CLI::ValidationError("--set", "'" + text + "' is not path=value");
    }
    return {text.substr(0, equals), text.substr(equals + 1)};
}

struct PlainText {
    std::string operator()(const double* value) const { return number_text(*value); }
    std::string operator()(const int* value) const { return std::to_string(*value); }
    std::string operator()(const std::uint64_t* value) const { return std::to_string(*value); }
    std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
    std::string operator()(const std::string* value) const { return *value; }
    std::string operator()(const std::vector<double>*) const { return ""; }  // no flag's value
};

/// The value at `path` as one would write it behind a flag.
std::string plain_value(const Describe& describe, std::string_view path) {
    std::string text;
    const auto on_field = [&](const Field& field) {
        if (field.path == path) text = std::visit(PlainText{}, field.value);
    };
    walk(describe, on_field, [](const std::string&) {});
    return text;
}

/// Files that are opened later must not take the numbers of standard streams that are closed: logs
/// would be written into them.
void fill_standard_streams() {
    int fd = -1;
    do {
        fd = ::open("/dev/null", O_RDWR);
    } while (fd >= 0 && fd <= STDERR_FILENO);
    if (fd >= 0) ::close(fd);
}

}  // namespace

void add_flags(CLI::App& app, CommandLine& line, const std::vector<ShortFlag>& flags,
               const std::string& example, const Describe& defaults) {
    for (const auto& [flag, path, help] : flags) {
        app.add_option_function<std::string>(
               flag,
               [&line, where = std::string(path)](const std::string& value) {
                   line.settings.emplace_back(where, value);
               },
               help)
            ->default_str(defaults ? plain_value(defaults, path) : "");
    }
    app.add_option("--config", line.files, "TOML file; may be repeated, later wins")
        ->allow_extra_args(false);
    app.add_option_function<std::vector<std::string>>(
           "--set",
           [&line](const std::vector<std::string>& values) {
               for (const std::string& value : values)
                   line.settings.push_back(path_and_value(value));
           },
           "path=value, e.g. " + example + "; wins over other flags; may be repeated, later wins")
        ->allow_extra_args(false);
    app.add_option("--log-level", line.log_level, "trace, debug, info, warning, error or off");
    app.add_flag("--print-config", line.print_config, "print the resolved configuration, and end");
    app.add_flag("--print-fields", line.print_fields,
                 "print every setting with type, value, range and meaning as JSON, and end");
}

void resolve(const CommandLine& line, const Describe& describe) {
    for (const std::string& file : line.files) load_file(describe, file);
    for (const auto& [path, value] : line.settings) set(describe, path, value);
}

bool print_wanted(const CommandLine& line, const Describe& describe) {
    if (line.print_config) std::cout << print(describe);
    if (line.print_fields) std::cout << print_fields(describe) << '\n';
    return line.print_config || line.print_fields;
}

int run_program(CLI::App& app, int argc, char** argv, const std::string& program,
                const std::function<int()>& run) {
    fill_standard_streams();
    const auto failed = [&program](const std::exception& error, int code) {
        std::cerr << program << ": " << error.what() << '\n';
        return code;
    };
    try {
        app.parse(argc, argv);
        return run();
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : kExitUsage;
    } catch (const ConfigError& error) {
        return failed(error, kExitUsage);
    } catch (const std::invalid_argument& error) {
        return failed(error, kExitUsage);
    } catch (const std::exception& error) {
        return failed(error, kExitFailed);
    }
}

}  // namespace k3d::config
