// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/spec/drill_spec.h"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

#include "optimizer/spec/settings.h"

namespace k3d::optimizer::spec {

namespace {

/// What is said of a server of our own must not be lost on one that runs already, nor the other way
/// round.
void check_place(const DrillSpec& spec) {
    if ((spec.agent_port == 0) != (spec.server_port == 0)) {
        throw std::invalid_argument(
            "agent_port and server_port name a running server together, or neither does");
    }
    if (spec.agent_port == 0) {
        if (spec.host == DrillSpec().host) return;
        throw std::invalid_argument(fmt::format(
            "host {} is where a server runs already, but agent_port and server_port are missing",
            spec.host));
    }
    std::vector<std::string> lost;
    if (spec.http_port >= 0) lost.push_back(fmt::format("http_port {}", spec.http_port));
    if (!spec.pace.empty()) lost.push_back("pace " + spec.pace);
    if (!spec.server_config.empty()) lost.push_back("server_config " + spec.server_config);
    if (!spec.server_program.empty()) lost.push_back("server_program " + spec.server_program);
    for (const std::string& setting : parse_settings(spec.settings).server) {
        lost.push_back("server:" + setting);
    }
    if (lost.empty()) return;
    throw std::invalid_argument(
        fmt::format("a server that runs already is not told {}; agent_port {} names one",
                    fmt::join(lost, ", "), spec.agent_port));
}

}  // namespace

void check(const DrillSpec& spec) {
    const auto last = static_cast<std::uint64_t>(spec.first) + static_cast<std::uint64_t>(spec.runs) - 1;
    if (spec.seed > std::numeric_limits<std::uint64_t>::max() - last) {
        throw std::invalid_argument(
            fmt::format("seed {} is too large for {} runs", spec.seed, spec.runs));
    }
    check_place(spec);
    const DrillSetup& s = spec.setup;
    if (s.go_to_shortest > s.go_to_longest) {
        throw std::invalid_argument(fmt::format("go_to_shortest {} is above go_to_longest {}",
                                                s.go_to_shortest, s.go_to_longest));
    }
    if (s.roll_least > s.roll_most) {
        throw std::invalid_argument(
            fmt::format("roll_least {} is above roll_most {}", s.roll_least, s.roll_most));
    }
    parse_settings(spec.settings);
}

}  // namespace k3d::optimizer::spec
