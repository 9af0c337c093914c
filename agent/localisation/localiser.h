// SPDX-License-Identifier: BSD-3-Clause
// Where the robot is: refinement of the estimate while it explains what is seen, a particle filter
// for the rough answer from when it does not until one does again.
//
// Frame: team frame, so the side must be known. Errors with the reference's vision noise: median
// below 0.05 m and 1 degree (tests/agent/localisation). Deterministic: seed and inputs fix it.
#pragma once

#include <cstdint>

#include "agent/localisation/config.h"
#include "agent/localisation/particles.h"
#include "agent/localisation/refine.h"
#include "agent/perception/view.h"

namespace k3d::agent::localisation {

struct Location {
    Pose2 pose;
    double position_sd = 1e9;  ///< m
    double yaw_sd = 1e9;       ///< rad
    bool localised = false;    ///< spread small enough to act on, and the last views agreed
};

class Localiser {
  public:
    Localiser(const LocalisationConfig& config, std::uint64_t seed);

    /// Forgets everything; the robot may stand anywhere.
    void reset();

    /// One cycle. `odometry` is the motion since the cycle before, `dt` the time since. `view` is
    /// null in a cycle without vision; it is not looked at while the robot is down, since then the
    /// camera's pose is not known well enough.
    const Location& update(const perception::View* view, const Pose2& odometry, bool upright,
                           wire::Side side, double dt);

  private:
    void predict(const Pose2& odometry, bool upright, double dt);
    void correct(const perception::View& view);
    bool seek(const perception::View& view, const SensedPoses& sensed, const Cluster& cluster);
    void report();

    LocalisationConfig config_;
    Particles particles_;
    Estimate estimate_;
    Landmarks landmarks_{};
    wire::Side side_ = wire::Side::None;
    bool found_ = false;              ///< estimate_ rests on views
    int unexplained_ = 0;             ///< views in a row that estimate_ does not explain
    Pose2 since_view_;                ///< odometry since the particles were moved
    double position_variance_ = 0.0;  ///< and its error
    double yaw_variance_ = 0.0;
    Location location_;
};

}  // namespace k3d::agent::localisation
