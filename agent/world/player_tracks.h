// SPDX-License-Identifier: BSD-3-Clause
// The other players: position, velocity, lagged mean, whether they lie on the ground.
//
// Frame: team frame, metres, seconds of simulated time.
#pragma once

#include <array>
#include <vector>

#include "agent/world/beliefs.h"
#include "agent/world/config.h"
#include "agent/world/point_filter.h"
#include "common/wire/percepts.h"

namespace k3d::agent::world {

class PlayerTracks {
  public:
    PlayerTracks(const PlayersConfig& players, const TakerConfig& taker);

    void reset();
    /// To be called once a cycle, before the sightings of that cycle.
    void predict(double now);
    /// Seen at `position`, off by `sd` m on each axis. `fallen` none: cannot be told from this
    /// view.
    void see(bool mate, int unum, const Vec2& position, double sd, std::optional<bool> fallen,
             double now);
    /// A team-mate says where it is.
    void hear(int unum, const Vec2& position, bool fallen, double now);
    /// A team-mate says where it sees an opponent.
    void hear_of_opponent(int unum, const Vec2& position, double now);
    /// The robot's pose was corrected by a jump; the players were seen from the wrong one.
    void reseat(const Pose2& from, const Pose2& to);

    /// Those not forgotten, by number; this agent's own number is left out of the mates.
    void report(double now, int own_unum, std::vector<Player>& mates,
                std::vector<Player>& opponents) const;

  private:
    struct Track {
        PointFilter filter;
        double seen = -1e9;  ///< or heard of
        double eyes = -1e9;  ///< by own eyes
        double mean_time = -1e9;
        Vec2 mean_sum = Vec2::Zero();
        double mean_weight = 0.0;
        bool fallen = false;
    };
    using Team = std::array<Track, wire::kMaxUnum>;

    void measure(Track& track, const Vec2& position, double sd, double now);
    void report_team(const Team& team, bool mate, double now, int left_out,
                     std::vector<Player>& players) const;

    PlayersConfig players_;
    TakerConfig taker_;
    std::array<Team, 2> teams_;  ///< opponents, mates
    double now_ = -1e9;
};

}  // namespace k3d::agent::world
