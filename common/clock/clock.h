// SPDX-License-Identifier: BSD-3-Clause
// Simulated time: a count of 20 ms cycles, never a sum of floating-point steps.
#pragma once

#include <cstdint>

namespace k3d {

inline constexpr double kCycleSeconds = 0.02;  // one ODE step per cycle (reference 2.1)

/// Number of cycles since the simulation began.
struct Cycle {
    std::int64_t count = 0;

    double seconds() const { return static_cast<double>(count) * kCycleSeconds; }
    Cycle& operator++() {
        ++count;
        return *this;
    }
    auto operator<=>(const Cycle&) const = default;
};

}  // namespace k3d
