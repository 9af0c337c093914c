// SPDX-License-Identifier: BSD-3-Clause
// All sensors of one robot together: from the scene to one wire::Percepts a cycle.
#pragma once

#include "server/body/scene.h"
#include "server/percepts/force_resistance.h"
#include "server/percepts/inertial.h"
#include "server/percepts/vision.h"

namespace k3d::server::percepts {

class Senses {
  public:
    Senses(const VisionConfig& config, RandomStream noise)
        : interval_(config.interval), camera_(config, noise) {}

    void before_step(const body::Player& self) { accelerometer_.sample_before_step(*self.robot); }

    /// Fills everything but game state and hearing; `out` is reset first.
    void after_step(const body::Scene& scene, const body::Player& self, double time,
                    wire::Percepts& out);

  private:
    int interval_;
    Camera camera_;
    Accelerometer accelerometer_;
    ForceSensors forces_;
    int cycles_until_see_ = 0;
};

}  // namespace k3d::server::percepts
