// SPDX-License-Identifier: BSD-3-Clause
// Poses that follow from one view alone, without any memory: what a lost robot starts from.
//
// Frame: team frame.
#pragma once

#include <array>

#include "agent/localisation/map.h"
#include "agent/perception/view.h"

namespace k3d::agent::localisation {

struct SensedPoses {
    std::array<Pose2, 4> pose;
    int count = 0;
};

/// Two or more landmarks: the one pose that fits them best. One landmark and a straight line: up to
/// four poses, since the line says the heading but for quarter turns; those off the field are left
/// out. Less: none.
SensedPoses sensed_poses(const perception::View& view, const Landmarks& landmarks);

}  // namespace k3d::agent::localisation
