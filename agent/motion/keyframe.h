// SPDX-License-Identifier: BSD-3-Clause
// What motions made of keyframes (kick, getting up) have in common. Radians, seconds.
#pragma once

#include <algorithm>
#include <cmath>

#include "common/clock/clock.h"
#include "common/nao/model.h"

namespace k3d::agent::motion {

/// A pose, and how long the way to it takes.
struct Keyframe {
    double duration;
    nao::JointArray pose;
};

inline constexpr int kCalmCycles = 3;  ///< slow for this many cycles: at rest

/// At least one.
inline int cycles_of(double seconds) {
    return std::max(1, static_cast<int>(std::lround(seconds / kCycleSeconds)));
}

}  // namespace k3d::agent::motion
