// SPDX-License-Identifier: BSD-3-Clause
// From the wire's body percepts to what motion works with.
//
// In: degrees, body axes x right, y forward, z up. Out: radians, agent axes x forward, y left, z
// up.
#pragma once

#include "agent/motion/motion.h"
#include "common/wire/percepts.h"

namespace k3d::agent::perception {

/// Wire body axes (x right, y forward, z up) -> agent axes (x forward, y left, z up).
inline Vec3 agent_axes(const Vec3& wire) {
    return {wire.y(), -wire.x(), wire.z()};
}

/// Converts one frame. `sense` is the one of the frame before: a joint that the frame does not
/// report keeps its angle. A sole without a percept has no contact. Toe plates (type 4) are left
/// out: their forces are given in a frame that moves against the foot's.
void body_sense(const wire::Percepts& percepts, motion::BodySense& sense);

}  // namespace k3d::agent::perception
