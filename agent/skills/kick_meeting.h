// SPDX-License-Identifier: BSD-3-Clause
// Where to kick a rolling ball: a little before it comes to rest, since the last decimetres take it
// longer than all the way before. Team frame, metres, seconds.
#pragma once

#include "agent/skills/config.h"
#include "agent/skills/kick_position.h"
#include "agent/world/beliefs.h"
#include "common/math/geometry.h"

namespace k3d::agent::skills {

/// What a robot at `self` prepares for.
struct Meeting {
    int strike;          ///< of KickGeometry: with which kick
    Vec2 point;          ///< where the ball is to be hit
    Vec2 ball_at_hit;    ///< where it will be if the swing begins now
    bool arrived;        ///< a swing begun now hits it there
    bool rolling;        ///< it still rolls then, so there is no time to better the stance
};

class KickMeeting {
  public:
    /// `standing`: the robot does not walk at the moment. Without `may_kick` the stopping point.
    Meeting plan(const Pose2& self, const world::Ball& ball, const Vec2& target, bool may_kick,
                 bool standing, const KickGeometry& kick, const SkillConfig& config);
    /// Forgets what was chosen.
    void reset() {
        before_finish_ = -1.0;
        strike_ = -1;
    }

  private:
    int strike_ = -1;              ///< < 0: none chosen
    double before_finish_ = -1.0;  ///< m from the meeting to the stopping point; < 0: none chosen
    Vec2 finish_ = Vec2::Zero();   ///< of the roll for which it was chosen
};

}  // namespace k3d::agent::skills
