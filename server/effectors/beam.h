// SPDX-License-Identifier: BSD-3-Clause
// Beam: a player places its robot, with noise (reference 4, beam rules).
#pragma once

#include "common/config/fields.h"
#include "common/random/stream.h"
#include "common/wire/commands.h"
#include "server/body/scene.h"

namespace k3d::server::effectors {

struct BeamConfig {
    double noise_xy = 0.05;        // m, uniform
    double noise_angle_deg = 10.0;  // deg, uniform

    void describe(config::Fields& f) {
        f.number("noise_xy", noise_xy, {0.0, 1.0}, "m", "a beam lands within +- this in x and y");
        f.number("noise_angle_deg", noise_angle_deg, {0.0, 180.0}, "deg",
                 "a beam turns within +- this");
    }
};

/// Places the robot in its own half, torso 0.4 m high, upright, at rest.
void beam(body::Player& player, const wire::BeamCommand& command, const BeamConfig& config,
          RandomStream& noise);

}  // namespace k3d::server::effectors
