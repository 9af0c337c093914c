// SPDX-License-Identifier: BSD-3-Clause
// The materials of the world and how two of them mix (reference 5.5).
#include "server/physics/world.h"

namespace k3d::server::physics {

const Surface kGround{.slip = 0.005, .soft_erp = 0.2};
const Surface kRobotSurface{.slip = 0.005, .soft_erp = 0.6, .soft_cfm = 1e-4};
const Surface kBallSurface{
    .bounce = 0.8, .bounce_velocity = 0.8, .slip = 0.6, .soft_erp = 0.5, .soft_cfm = 0.05};
const Surface kSolidSurface{.bounce = 0.8, .bounce_velocity = 2.0};

namespace {
std::optional<double> mix(const std::optional<double>& a, const std::optional<double>& b) {
    if (a && b) return (*a + *b) / 2.0;
    return a ? a : b;
}
}  // namespace

Surface mixed(const Surface& a, const Surface& b) {
    return {mix(a.bounce, b.bounce), mix(a.bounce_velocity, b.bounce_velocity), mix(a.slip, b.slip),
            mix(a.soft_erp, b.soft_erp), mix(a.soft_cfm, b.soft_cfm)};
}

}  // namespace k3d::server::physics
