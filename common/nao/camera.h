// SPDX-License-Identifier: BSD-3-Clause
// How exactly the camera in the head sees (SimSpark reference 3.6): the server adds this noise, and
// agents reckon with it.
#pragma once

namespace k3d::nao {

inline constexpr double kSightDistanceNoise = 0.0965 / 100.0;  // sd relative to the distance
inline constexpr double kSightThetaNoiseDeg = 0.1480;          // sd, horizontal
inline constexpr double kSightPhiNoiseDeg = 0.1225;            // sd, vertical

}  // namespace k3d::nao
