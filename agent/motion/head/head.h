// SPDX-License-Identifier: BSD-3-Clause
// Turns the neck to where the head shall look, in the robot's level frame.
#pragma once

#include "agent/motion/joint_targets.h"
#include "agent/motion/motion.h"
#include "agent/motion/posture.h"

namespace k3d::agent::motion::head {

/// Neck angles for `request` (rad, yaw positive left, pitch positive up, against the level robot
/// frame), clamped to what the neck can do. The torso's pitch is taken out, so that the camera
/// holds its elevation while the robot leans.
void look(const HeadRequest& request, const Posture& posture, JointTargets& out);

}  // namespace k3d::agent::motion::head
