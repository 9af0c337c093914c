// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/spec/match_spec.h"

#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <stdexcept>

#include "optimizer/spec/settings.h"
#include "optimizer/spec/words.h"

namespace k3d::optimizer::spec {

namespace {

void check_file(const char* field, const std::string& path) {
    if (path.empty() || std::filesystem::is_regular_file(path)) return;
    throw std::invalid_argument(fmt::format("{}: no such file: {}", field, path));
}

}  // namespace

void check_command(const char* field, const std::string& command) {
    if (command.empty()) return;
    try {
        if (fill_command(command, {}).empty()) throw std::invalid_argument("it is blank");
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(fmt::format("{} '{}': {}", field, command, error.what()));
    }
}

void check(const MatchSpec& spec) {
    const auto last = static_cast<std::uint64_t>(spec.episodes) - 1;
    if (spec.seed > std::numeric_limits<std::uint64_t>::max() - last) {
        throw std::invalid_argument(
            fmt::format("seed {} is too large for {} episodes", spec.seed, spec.episodes));
    }
    check_file("server_config", spec.server_config);
    check_file("agent_config", spec.agent_config);
    check_command("keeper_command", spec.keeper_command);
    check_command("taker_command", spec.taker_command);
    parse_settings(spec.settings);
}

}  // namespace k3d::optimizer::spec
