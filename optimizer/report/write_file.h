// SPDX-License-Identifier: BSD-3-Clause
// A text into a file of a report.
#pragma once

#include <string>

namespace k3d::optimizer::report {

/// In place of what was there. Throws std::runtime_error naming a file that cannot be written.
void write_file(const std::string& path, const std::string& text);

}  // namespace k3d::optimizer::report
