// SPDX-License-Identifier: BSD-3-Clause
// The fields of a described struct as JSON, for programs that set them.
#include <cmath>
#include <nlohmann/json.hpp>

#include "common/config/config.h"
#include "common/config/walk.h"

namespace k3d::config {

namespace {

struct TypeName {
    const char* operator()(const double*) const { return "number"; }
    const char* operator()(const int*) const { return "integer"; }
    const char* operator()(const std::uint64_t*) const { return "seed"; }
    const char* operator()(const bool*) const { return "boolean"; }
    const char* operator()(const std::string*) const { return "text"; }
    const char* operator()(const std::vector<double>*) const { return "numbers"; }
};

nlohmann::ordered_json bound(double value) {
    if (!std::isfinite(value)) return nullptr;
    return value;
}

}  // namespace

std::string print_fields(const Describe& describe) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    const auto on_field = [&list](const Field& field) {
        nlohmann::ordered_json entry;
        entry["path"] = field.path;
        entry["type"] = std::visit(TypeName{}, field.value);
        entry["value"] = std::visit([](const auto* value) { return nlohmann::ordered_json(*value); },
                                    field.value);
        entry["min"] = bound(field.range.min);
        entry["max"] = bound(field.range.max);
        entry["unit"] = std::string(field.unit);
        entry["meaning"] = std::string(field.meaning);
        list.push_back(std::move(entry));
    };
    walk(describe, on_field, [](const std::string&) {});
    return list.dump();
}

}  // namespace k3d::config
