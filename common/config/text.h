// SPDX-License-Identifier: BSD-3-Clause
// Pieces of text in configuration files and messages. Private to common/config.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/config/fields.h"

namespace k3d::config {

/// Shortest form that reads back as the same double, "3.0" for whole numbers.
std::string number_text(double value);

/// "0 to 0.1", "at least 0", "at most 1", empty if every number is allowed.
std::string range_text(Range range);

/// As a TOML basic string, with its quotes.
std::string quoted(std::string_view text);

/// The known path nearest to `path` in spelling, empty if none is known.
std::string nearest(std::string_view path, const std::vector<std::string>& known);

}  // namespace k3d::config
