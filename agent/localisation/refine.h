// SPDX-License-Identifier: BSD-3-Clause
// The pose that explains one view best, given where the robot was believed to be.
//
// Frame: team frame; covariances over (x m, y m, yaw rad). With vision as good as the server's
// (0.0965 % of the distance, 0.148 degrees, SimSpark reference 3.6) two landmarks or a landmark and
// lines fix the pose to a few centimetres; particles alone are too coarse for that.
#pragma once

#include "agent/localisation/map.h"
#include "agent/perception/view.h"

namespace k3d::agent::localisation {

struct Estimate {
    Pose2 pose;
    Mat3 covariance = Vec3(1e4, 1e4, 1e2).asDiagonal();  ///< as good as nothing known
};

struct Fit {
    Estimate estimate;
    int landmarks = 0;   ///< seen and explained
    int sightings = 0;   ///< landmarks and lines seen
    double share = 0.0;  ///< of the sightings explained, landmarks counted twice; 0 if none
};

/// Gauss-Newton over landmarks, the lines matched from the current pose, and the prior.
Fit refine(const perception::View& view, const Landmarks& landmarks, const Estimate& prior);

}  // namespace k3d::agent::localisation
