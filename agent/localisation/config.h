// SPDX-License-Identifier: BSD-3-Clause
// Parameters of localisation; file agent/config/localisation.toml.
#pragma once

#include "common/config/fields.h"

namespace k3d::agent::localisation {

struct LocalisationConfig {
    int particles = 200;  // with poses sensed from landmarks mixed in, more find nothing sooner
    double odometry_position = 0.2;
    double odometry_yaw = 0.2;
    double drift_position = 0.08;
    double drift_yaw = 0.1;
    double fallen_position = 0.3;
    double fallen_yaw = 0.8;
    double explained_share = 0.75;
    int lost_after = 3;
    double max_injection = 0.2;
    double localised_position = 0.5;
    double localised_yaw = 0.26;

    void describe(config::Fields& f) {
        f.integer("particles", particles, {20, 5000}, "", "particles of the filter");
        f.number("odometry_position", odometry_position, {0, 2}, "",
                 "error of a step as a share of its length");
        f.number("odometry_yaw", odometry_yaw, {0, 2}, "",
                 "error of a turn as a share of its angle");
        f.number("drift_position", drift_position, {0, 2}, "m/s^0.5",
                 "spread gained while upright, besides the odometry's error");
        f.number("drift_yaw", drift_yaw, {0, 4}, "rad/s^0.5", "the same for the heading");
        f.number("fallen_position", fallen_position, {0, 5}, "m/s^0.5", "spread gained while down");
        f.number("fallen_yaw", fallen_yaw, {0, 10}, "rad/s^0.5", "the same for the heading");
        f.number("explained_share", explained_share, {0.3, 1}, "",
                 "share of the sightings that a good pose explains");
        f.integer("lost_after", lost_after, {1, 50}, "sees",
                  "unexplained sees in a row after which a new pose is sought");
        f.number("max_injection", max_injection, {0, 0.9}, "",
                 "largest share of particles replaced by sensed poses in one see");
        f.number("localised_position", localised_position, {0.01, 10}, "m",
                 "spread above which the pose is not to be acted on");
        f.number("localised_yaw", localised_yaw, {0.01, 3}, "rad", "the same for the heading");
    }
};

}  // namespace k3d::agent::localisation
