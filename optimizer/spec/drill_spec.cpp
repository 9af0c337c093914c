// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/spec/drill_spec.h"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

#include "optimizer/spec/settings.h"

namespace k3d::optimizer::spec {

void check(const DrillSpec& spec) {
    const auto last = static_cast<std::uint64_t>(spec.first) + static_cast<std::uint64_t>(spec.runs) - 1;
    if (spec.seed > std::numeric_limits<std::uint64_t>::max() - last) {
        throw std::invalid_argument(
            fmt::format("seed {} is too large for {} runs", spec.seed, spec.runs));
    }
    if ((spec.agent_port == 0) != (spec.server_port == 0)) {
        throw std::invalid_argument(
            "agent_port and server_port name a running server together, or neither does");
    }
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
