// SPDX-License-Identifier: BSD-3-Clause
// Where the feet shall be, cycle by cycle: the step clock and the foot trajectories of a walk with
// a given velocity, without any balance.
//
// Frame: the walk frame, level, moving with the torso: origin midway between the hips' ground
// points, x forward, y left, z up from the ground. Metres, radians, seconds.
#pragma once

#include <array>

#include "agent/kinematics/leg.h"
#include "agent/motion/motion.h"
#include "agent/motion/walk/config.h"

namespace k3d::agent::motion::walk {

using kinematics::Side;

/// Where one foot shall be now.
struct Foot {
    Pose2 ground;       ///< sole point and direction
    double lift = 0.0;  ///< above the ground
    double air = 0.0;   ///< 0 on the ground, 1 in the middle of the swing
};

/// Shift of the next landing asked by balance.
struct Correction {
    double forward = 0.0;
    double left = 0.0;
};

class Steps {
  public:
    /// `half_width`: a foot's distance from the middle plane; `scale`: leg length over type 0's.
    Steps(const Config& config, double half_width, double scale);

    /// Both feet side by side; the next step lifts the foot of `first`.
    void start(Side first);
    /// One cycle with the torso moving at `velocity`.
    void advance(const Walk& velocity, const Correction& correction);

    const Foot& foot(Side side) const { return feet_[static_cast<std::size_t>(side)]; }
    double phase() const { return phase_; }    ///< 0..1 within the step
    bool stepped() const { return stepped_; }  ///< a new step began in the last advance()
    /// Swing of the hips over the support foot, -1 right .. 1 left.
    double sway() const;
    /// How far the feet are from standing side by side (m, with yaw weighted by 0.1 m/rad).
    double distance_from_stance() const;
    Pose2 neutral(Side side, const Walk& velocity) const;

  private:
    void move_over_ground(Foot& foot, const Walk& velocity) const;
    void swing_foot(const Walk& velocity, const Correction& correction);

    const Config& config_;
    double half_width_;
    double scale_;
    std::array<Foot, 2> feet_;
    Side swing_ = Side::Left;
    double phase_ = 0.0;
    bool stepped_ = false;
    Pose2 lifted_from_;  ///< where the swing foot left the ground, walk frame of that moment
    bool in_air_ = false;
};

}  // namespace k3d::agent::motion::walk
