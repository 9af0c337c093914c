// SPDX-License-Identifier: BSD-3-Clause
// The ball: position, velocity, whether it moves, and where it will stop.
//
// Frame: team frame, metres, seconds of simulated time.
#pragma once

#include <array>

#include "agent/world/ball_finish.h"
#include "agent/world/beliefs.h"
#include "agent/world/config.h"
#include "agent/world/point_filter.h"

namespace k3d::agent::world {

class BallTrack {
  public:
    explicit BallTrack(const BallConfig& config);

    void reset();
    /// To be called once a cycle, before the sightings of that cycle.
    void predict(double now);
    /// Seen at `position`, which is off by `sd` m on each axis.
    void see(const Vec2& position, double sd, double now);
    /// A team-mate says that it sees the ball; taken only if this agent has not for a while.
    void hear(const Vec2& position, const Vec2& velocity, double now);
    /// This view should have shown the ball and did not.
    void miss();
    /// The robot's pose was corrected by a jump; the ball was seen from the wrong one.
    void reseat(const Pose2& from, const Pose2& to);

    void report(double now, Ball& ball);
    bool known(double now) const;
    const Vec2& position() const { return filter_.position(); }

  private:
    void start(const Vec2& position, double sd);
    void judge_motion();
    Vec2 position_before(double now) const;

    struct Moment {
        double time = -1e9;
        Vec2 position = Vec2::Zero();
    };

    BallConfig config_;
    PointFilter filter_;
    BallFinish finish_;
    double now_ = -1e9;       ///< the filter's time
    double seen_ = -1e9;      ///< by own eyes
    double heard_ = -1e9;     ///< or seen
    double measured_ = -1e9;  ///< when the filter last took a measurement
    bool moving_ = false;
    int misses_ = 0;
    std::array<Moment, 32> history_{};  ///< ring of the last cycles, more than 0.5 s of them
    std::size_t next_ = 0;
};

}  // namespace k3d::agent::world
