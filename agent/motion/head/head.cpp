// SPDX-License-Identifier: BSD-3-Clause
#include "agent/motion/head/head.h"

#include <algorithm>
#include <cmath>

namespace k3d::agent::motion::head {

namespace {

constexpr double kMaxYaw = radians(118.0);
constexpr double kMaxPitch = radians(43.0);

}  // namespace

void look(const HeadRequest& request, const Posture& posture, JointTargets& out) {
    // The direction wanted, turned into the torso: yaw first, then pitch, as the neck does.
    const Vec3 level(std::cos(request.pitch) * std::cos(request.yaw),
                     std::cos(request.pitch) * std::sin(request.yaw), std::sin(request.pitch));
    const Vec3 direction = posture.torso.conjugate() * level;
    out[nao::JointId::HeadYaw] =
        std::clamp(std::atan2(direction.y(), direction.x()), -kMaxYaw, kMaxYaw);
    out[nao::JointId::HeadPitch] = std::clamp(
        std::atan2(direction.z(), std::hypot(direction.x(), direction.y())), -kMaxPitch, kMaxPitch);
}

}  // namespace k3d::agent::motion::head
