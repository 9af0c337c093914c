// SPDX-License-Identifier: BSD-3-Clause
// Finds what TOML forbids and toml++ 3.3 stumbles over. Private to common/config.
#pragma once

#include <optional>
#include <string_view>

namespace k3d::config {

/// Line (from 1) of the first byte beyond ASCII that is outside quotes and comments or behind a
/// backslash. TOML allows none there, but toml++ 3.3 takes such letters into a switch that has no
/// case for them: undefined behaviour instead of a parse error.
std::optional<int> stray_letter_line(std::string_view toml);

}  // namespace k3d::config
