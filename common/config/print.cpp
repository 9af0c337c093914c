// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <utility>

#include "common/config/config.h"
#include "common/config/text.h"
#include "common/config/walk.h"

namespace k3d::config {

namespace {

struct ValueText {
    std::string operator()(const double* value) const { return number_text(*value); }
    std::string operator()(const int* value) const { return std::to_string(*value); }
    std::string operator()(const std::uint64_t* value) const {
        const std::string digits = std::to_string(*value);
        return *value > std::numeric_limits<std::int64_t>::max() ? quoted(digits) : digits;
    }
    std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
    std::string operator()(const std::string* value) const { return quoted(*value); }
    std::string operator()(const std::vector<double>* values) const {
        std::string out = "[";
        for (const double value : *values) {
            if (out.size() > 1) out += ", ";
            out += number_text(value);
        }
        return out + "]";
    }
};

/// "m, 0 to 0.1: how high the swing foot is lifted"
std::string comment(const Field& field) {
    std::string out(field.unit);
    std::string allowed = range_text(field.range);
    if (field.choices != nullptr) {
        for (const std::string& choice : *field.choices) {
            allowed += (allowed.empty() ? "" : " | ") + choice;
        }
    }
    if (!out.empty() && !allowed.empty()) out += ", ";
    out += allowed;
    if (!out.empty()) out += ": ";
    return out + std::string(field.meaning);
}

}  // namespace

std::string print(const Describe& describe, Comments comments) {
    // A field after a section would belong to that section: each section gathers its own text.
    std::vector<std::pair<std::string, std::string>> sections{{"", ""}};
    const auto on_field = [&](const Field& field) {
        const std::string_view section = section_of(field.path);
        for (auto& [path, text] : sections) {
            if (path != section) continue;
            text += std::string(key_of(field.path)) + " = " + std::visit(ValueText{}, field.value);
            if (comments == Comments::Yes) text += "  # " + comment(field);
            text += '\n';
        }
    };
    const auto on_section = [&sections](const std::string& path) {
        sections.push_back({path, ""});
    };
    walk(describe, on_field, on_section);
    std::string out;
    for (const auto& [path, text] : sections) {
        if (text.empty()) continue;
        if (!out.empty()) out += "\n";
        if (!path.empty()) out += "[" + path + "]\n";
        out += text;
    }
    return out;
}

}  // namespace k3d::config
