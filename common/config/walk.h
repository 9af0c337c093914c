// SPDX-License-Identifier: BSD-3-Clause
// The fields of a described struct as one stream of values with paths. Private to common/config.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "common/config/config.h"

namespace k3d::config {

/// One field while describe() is at it; `value` and the views die when the callback returns.
struct Field {
    std::string path;  ///< "walk.step_height"
    std::variant<double*, int*, std::uint64_t*, bool*, std::string*, std::vector<double>*> value;
    Range range;                              ///< of numbers
    std::string_view unit;                    ///< of numbers
    const std::vector<std::string>* choices;  ///< of texts, else null
    std::string_view meaning;
};

using OnField = std::function<void(const Field&)>;
using OnSection = std::function<void(const std::string& path)>;

/// Calls back for every field, and for every section before its fields, in the described order.
void walk(const Describe& describe, const OnField& on_field, const OnSection& on_section);

/// "walk" and "step_height" of "walk.step_height"; the section is empty at the top.
std::string_view section_of(std::string_view path);
std::string_view key_of(std::string_view path);

}  // namespace k3d::config
