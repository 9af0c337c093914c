// SPDX-License-Identifier: BSD-3-Clause
// The camera's tilt, corrected by what is seen of the ground.
#pragma once

#include <span>

#include "common/math/geometry.h"

namespace k3d::agent::perception {

/// Rotation to apply after the given camera rotation so that `ground` lies level. The points are
/// given relative to the camera in robot axes (z up), their true height being -camera_height up to
/// a few centimetres. Least squares weighted by the vertical noise of vision (common/nao/camera.h),
/// with a prior of 3 degrees and 3 cm: no points, no correction.
Quat level(std::span<const Vec3> ground, double camera_height);

}  // namespace k3d::agent::perception
