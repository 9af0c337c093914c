// SPDX-License-Identifier: BSD-3-Clause
// Kicks a ball that lies within reach of a foot: leans over the other foot, swings, sets the foot
// down and returns to the stand, all as keyframes (mirrored for the left foot). Straight ahead the
// distance wanted mixes a far and a near swing, keyframe by keyframe; beyond what they reach, and to the
// side, there is one.
//
// The motion is open-loop and short, so that it is over before a small error grows; keyframes are
// found by search in the exact physics (see kick.toml). Radians, seconds, metres.
#pragma once

#include "agent/motion/joint_targets.h"
#include "agent/motion/keyframe.h"
#include "agent/motion/kick/config.h"
#include "agent/motion/kick/reach.h"
#include "agent/motion/motion.h"
#include "agent/motion/posture.h"

namespace k3d::agent::kick {

class KickEngine {
  public:
    explicit KickEngine(const Config& config) : config_(config) {
        frames_.reserve(16);  // more than any swing has
    }

    /// Begins the kick that fits the ball's place and the direction best; `stand` is the pose to end in.
    void start(const motion::Kick& kick, const nao::JointArray& stand);
    /// Writes all joints but the head's. False once it stands quietly again.
    bool step(const motion::BodySense& sense, const motion::Posture& posture,
              motion::JointTargets& out);

  private:
    /// Swings to mix for a strike at this distance, 0 being all of the first.
    struct Mix {
        const Swing& near;
        const Swing& far;
        double far_share;
    };

    Mix mix_for(double distance) const;
    nao::JointArray pose_of(const Mix& mix, std::size_t k) const;
    bool is_quiet(const motion::Posture& posture);

    Config config_;
    std::vector<motion::Keyframe> frames_;  ///< all of the running kick
    std::size_t frame_ = 0;         ///< the running one
    int cycle_ = 0;                 ///< of the running keyframe, or of settling after the last
    int calm_cycles_ = 0;           ///< in a row
    Strike strike_;
    bool fresh_ = false;       ///< from_ is not known yet
    nao::JointArray from_{};   ///< where the running keyframe began
    nao::JointArray stand_{};
};

}  // namespace k3d::agent::kick
