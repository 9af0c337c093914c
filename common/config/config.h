// SPDX-License-Identifier: BSD-3-Clause
// TOML text <-> described structs (see fields.h).
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "common/config/fields.h"

namespace k3d::config {

/// What is wrong, with "file:line: " in front, all faults of the file at once, one a line.
class ConfigError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

using Describe = std::function<void(Fields&)>;

/// Sets the fields that the text names. Unknown key (with the nearest known one), wrong type or
/// out-of-range value: ConfigError, and no field is changed. `file` is used in messages.
void load_text(const Describe& describe, std::string_view toml, std::string_view file);
/// The same for a file; a missing or unreadable file is a ConfigError that names it.
void load_file(const Describe& describe, const std::string& path);
/// Sets one field by path, as flags do: set(d, "walk.step_height", "0.03").
void set(const Describe& describe, std::string_view path, std::string_view value);
/// What a TOML text sets, in the order of its keys, as flags say it: "walk.step_height=0.03". It is not asked
/// whether there are such fields. ConfigError for what is no TOML, or a kind of value that no field has.
std::vector<std::string> assignments(std::string_view toml, std::string_view file);
/// The same of a file; a missing or unreadable file is a ConfigError that names it.
std::vector<std::string> assignments_of_file(const std::string& path);
enum class Comments { Yes, No };
/// The resolved configuration as TOML, with comments: each field with its unit, range and meaning.
std::string print(const Describe& describe, Comments comments = Comments::Yes);
/// The fields themselves, for programs: a JSON list of {"path", "type" (number, integer, seed,
/// boolean, text, numbers), "value", "min", "max" (null: none), "unit", "meaning"}.
std::string print_fields(const Describe& describe);
/// Line (from 1) of the value or section at `path` in a TOML text; none if it has none, or if the
/// text is no TOML. For faults that only show once all values are known.
std::optional<int> line_of(std::string_view toml, std::string_view path);
/// The text at `path`; none if there is no text. For what must be known before the fields are.
std::optional<std::string> text_at(std::string_view toml, std::string_view path);

template <class Struct>
Describe describing(Struct& s) {
    return [&s](Fields& fields) { s.describe(fields); };
}

}  // namespace k3d::config
