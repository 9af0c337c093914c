// SPDX-License-Identifier: BSD-3-Clause
// What can be tuned: the settings of k3d-agent as the program itself tells them.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace k3d::optimizer::spec {

/// A number among the agent's settings, or an element of one that is a list of numbers.
struct AgentField {
    std::string path;  ///< "keeper.hold_threshold"; of an element "kick.duration_s.0"
    bool integer = false;
    double value = 0.0;  ///< without any setting
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    std::string unit;
};

struct AgentFields {
    std::vector<AgentField> numbers;  ///< in the order in which the agent describes them
    std::vector<std::string> texts;   ///< paths that take a text, such as a network's file
    std::map<std::string, std::vector<double>> lists;  ///< whole, by path

    const AgentField* find(std::string_view path) const;
};

/// Of what `program --print-fields` prints. Throws std::runtime_error if that is no such list.
AgentFields parse_agent_fields(std::string_view json);

/// Runs `program` (empty: k3d-agent beside this program). Throws process::ProcessError if it cannot
/// be started, std::runtime_error if it gives no list.
AgentFields ask_agent_fields(const std::string& program);

}  // namespace k3d::optimizer::spec
