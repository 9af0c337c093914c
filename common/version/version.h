// SPDX-License-Identifier: BSD-3-Clause
// Which code this is, for results that must be traceable.
#pragma once

#include <string_view>

namespace k3d {

/// Version and commit, e.g. "0.1.0+4b65ab3", with "-dirty-" and a hash of the changes if tracked
/// files had any; without a git checkout "+files-" and a hash over the code's files.
std::string_view code_version();

}  // namespace k3d
