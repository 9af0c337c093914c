// SPDX-License-Identifier: BSD-3-Clause
// What a drill is worth, from the figures that it measured; larger is better.
#pragma once

#include <optional>

#include "common/episode/result.h"

namespace k3d::optimizer::fitness {

/// Speed over the way, m/s. After a fall only the way counts, as if the robot had lain until the end
/// of 30 s: falling fast must not pay.
std::optional<double> walk_forward(const k3d::episode::Result& result);

/// Turning rate, rad/s, less 0.2 per metre of drift; 0 for a robot that fell.
std::optional<double> walk_turn(const k3d::episode::Result& result);

/// Speed towards the targets, m/s, less 0.05 for each fall in ten minutes.
std::optional<double> go_to(const k3d::episode::Result& result);

/// Equation (1) of the paper, its distance factor capped at 6 m; -1 for a kick that failed.
std::optional<double> kick(const k3d::episode::Result& result);

/// Minus the time until the ball is kicked, s; without a kick -30: the limit of 25 s and a penalty.
std::optional<double> possession(const k3d::episode::Result& result);

/// Minus the paper's loss: the mean squared error of the predicted stopping point, m^2.
std::optional<double> ball_prediction(const k3d::episode::Result& result);

}  // namespace k3d::optimizer::fitness
