// SPDX-License-Identifier: BSD-3-Clause
// Particle filter over the robot's pose: keeps several answers alive while views are ambiguous.
//
// Frame: team frame. It is coarse on purpose (its noise is far above the sensors'), so that
// particles near the truth survive; refine.h turns its answer into centimetres. Augmented Monte
// Carlo localisation: when views fit worse than they used to, particles are replaced by poses
// sensed from landmarks (Thrun, Burgard, Fox: Probabilistic Robotics, table 8.3).
#pragma once

#include <vector>

#include "agent/localisation/config.h"
#include "agent/localisation/map.h"
#include "agent/localisation/sensed_poses.h"
#include "agent/perception/view.h"
#include "common/random/stream.h"

namespace k3d::agent::localisation {

struct Cluster {
    Pose2 pose;
    double weight = 0.0;  ///< share of the total weight within 1 m and 30 degrees of the best
};

class Particles {
  public:
    Particles(const LocalisationConfig& config, RandomStream random);

    void spread_over_field();
    /// About a pose believed so far, with these deviations and some more.
    void gather(const Pose2& pose, double position_sd, double yaw_sd);
    /// Moves all by `step`, given in the robot's frame, with the given deviations added.
    void move(const Pose2& step, double position_sd, double yaw_sd);
    /// Weighs by one view, draws anew, mixes in sensed poses. Returns the best cluster before that.
    Cluster weigh(const perception::View& view, const Landmarks& landmarks,
                  const SensedPoses& sensed);

  private:
    struct Particle {
        Vec2 position;
        double yaw;  ///< not wrapped
        double weight;
    };

    /// What all particles are compared with, worked out once a view.
    struct Mark {
        Vec2 seen;   ///< robot frame
        Vec2 truth;  ///< team frame
        double inverse_d2, along_weight, across_weight;
    };
    struct Straight {
        Vec2 middle;  ///< robot frame
        Vec2 heading;
        double offset_weight;
    };

    void prepare(const perception::View& view, const Landmarks& landmarks);
    double cost(const Particle& particle) const;
    Cluster best_cluster() const;
    void forget_fit();
    void resample(const SensedPoses& sensed, double injected_share);
    double jitter(double deviation);

    LocalisationConfig config_;
    RandomStream random_;
    std::vector<Particle> particles_;
    std::vector<Particle> drawn_;
    std::vector<Mark> marks_;
    std::vector<Straight> straights_;
    double fit_slow_ = 1.0;  ///< long and short means of how well views fit, 0..1
    double fit_fast_ = 0.0;
};

}  // namespace k3d::agent::localisation
