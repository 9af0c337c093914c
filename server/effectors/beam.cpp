// SPDX-License-Identifier: BSD-3-Clause
#include "server/effectors/beam.h"

#include <algorithm>

#include "common/field/field.h"

namespace k3d::server::effectors {

void beam(body::Player& player, const wire::BeamCommand& command, const BeamConfig& config,
          RandomStream& noise) {
    const double x = command.x + noise.uniform(-1.0, 1.0) * config.noise_xy;
    const double y = command.y + noise.uniform(-1.0, 1.0) * config.noise_xy;
    const double angle = command.angle_deg + noise.uniform(-1.0, 1.0) * config.noise_angle_deg;
    const Vec3 in_team(std::clamp(x, -field::kLength / 2.0, 0.0),
                       std::clamp(y, -field::kWidth / 2.0, field::kWidth / 2.0),
                       field::kAgentRadius);
    const double turned = player.team == wire::Side::Right ? kPi : 0.0;
    player.robot->place(body::flipped(in_team, player.team), radians(angle) + turned);
}

}  // namespace k3d::server::effectors
