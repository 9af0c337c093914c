// SPDX-License-Identifier: BSD-3-Clause
// TOML value -> field value, with the reason if it does not fit. Private to common/config.
#pragma once

#include <string>

#include <toml++/toml.h>

#include "common/config/walk.h"

namespace k3d::config {

/// Checks a value against a field, e.g. "is 3.2, allowed is 0 to 1"; empty if it fits.
/// Sets the field if it fits and `store` is true.
std::string assign(const Field& field, const toml::node& node, bool store);

}  // namespace k3d::config
