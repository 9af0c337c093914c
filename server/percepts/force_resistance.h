// SPDX-License-Identifier: BSD-3-Clause
// The force sensors of the feet and toes (reference 3.5). Foot frame, N and m.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "common/wire/percepts.h"
#include "server/body/robot.h"

namespace k3d::server::percepts {

/// All sensors of one robot. A reading lasts while the sole touches something; a sleeping
/// robot's contacts carry no force in the solver, and the last reading stays.
class ForceSensors {
  public:
    using Readings = std::array<std::optional<wire::FootForce>, wire::kFootSensorCount>;

    void update(const body::Robot& robot, std::span<const physics::Contact> contacts);
    const Readings& readings() const { return readings_; }

  private:
    Readings readings_;
    std::array<wire::FootForce, wire::kFootSensorCount> last_;
};

}  // namespace k3d::server::percepts
