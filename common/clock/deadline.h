// SPDX-License-Identifier: BSD-3-Clause
// Wall time that is left, as poll() wants it.
#pragma once

#include <algorithm>
#include <chrono>

namespace k3d {

/// Milliseconds until then, an hour at the most. Rounded up, so that a wait never ends before its
/// deadline.
inline int remaining_ms(std::chrono::steady_clock::time_point deadline) {
    const auto rest = deadline - std::chrono::steady_clock::now();
    const auto ms = std::chrono::ceil<std::chrono::milliseconds>(rest).count();
    return static_cast<int>(std::clamp<long long>(ms, 0, 3'600'000));
}

}  // namespace k3d
