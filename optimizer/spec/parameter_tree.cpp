// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/spec/parameter_tree.h"

#include <algorithm>

namespace k3d::optimizer::spec {

namespace {
constexpr double kInf = std::numeric_limits<double>::infinity();
}

ParameterTree::ParameterTree(const AgentFields& fields)
    : fields_(fields.numbers), wanted_(fields.numbers.size()) {
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        Node* node = &root_;
        std::string_view rest = fields_[i].path;
        while (true) {
            const auto dot = rest.find('.');
            const std::string key(rest.substr(0, dot));
            auto& children = node->children;
            auto found = std::find_if(children.begin(), children.end(),
                                      [&key](const Node& child) { return child.key == key; });
            if (found == children.end()) found = children.insert(found, Node{key, {}});
            node = &*found;
            if (dot == std::string_view::npos) break;
            rest.remove_prefix(dot + 1);
        }
        node->field = &fields_[i];
        node->wanted = &wanted_[i];
        node->wanted->integer = fields_[i].integer;
    }
}

void ParameterTree::describe(config::Fields& f) {
    root_.describe(f);
}

void ParameterTree::Node::describe(config::Fields& f) {
    for (Node& child : children) f.section(child.key, child);
    if (field == nullptr) return;
    const config::Range range{field->min, field->max};
    f.number("lower", wanted->lower, range, field->unit, "the search stays above");
    f.number("upper", wanted->upper, range, field->unit, "the search stays below");
    f.number("start", wanted->start, range, field->unit, "where it begins; else the agent's value");
    f.number("deviation", wanted->deviation, {0.0, kInf}, field->unit,
             "of the first samples; else a fifth of the width");
    f.boolean("integer", wanted->integer, "whole numbers only; so for settings that are whole");
    f.boolean("frozen", wanted->frozen, "every candidate has the start");
}

}  // namespace k3d::optimizer::spec
