// SPDX-License-Identifier: BSD-3-Clause
// The [parameters] section of an experiment: a section for each number that the agent has, so that a
// misspelt path is found as any other unknown key is.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "common/config/fields.h"
#include "optimizer/spec/agent_fields.h"

namespace k3d::optimizer::spec {

/// What an experiment may say of one parameter; NaN: not said.
struct Wanted {
    static constexpr double kUnsaid = std::numeric_limits<double>::quiet_NaN();
    double lower = kUnsaid;
    double upper = kUnsaid;
    double start = kUnsaid;
    double deviation = kUnsaid;
    bool integer = false;
    bool frozen = false;
};

/// Sections by the dots of the paths; the leaves are the agent's fields.
class ParameterTree {
  public:
    explicit ParameterTree(const AgentFields& fields);

    void describe(config::Fields& f);

    /// By index into AgentFields::numbers.
    const std::vector<Wanted>& wanted() const { return wanted_; }

  private:
    struct Node {
        std::string key;
        std::vector<Node> children;
        const AgentField* field = nullptr;  ///< of a leaf
        Wanted* wanted = nullptr;
        void describe(config::Fields& f);
    };

    std::vector<AgentField> fields_;
    std::vector<Wanted> wanted_;
    Node root_;
};

}  // namespace k3d::optimizer::spec
