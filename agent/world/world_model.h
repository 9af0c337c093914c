// SPDX-License-Identifier: BSD-3-Clause
// From percepts, body state and team-mates' messages to beliefs: perception, localisation and the
// tracks of ball and players, one cycle at a time.
//
// Frame of the result: team frame (beliefs.h). Deterministic: configuration, seed and inputs fix
// it.
#pragma once

#include <cstdint>
#include <span>

#include "agent/localisation/localiser.h"
#include "agent/motion/motion.h"
#include "agent/perception/view.h"
#include "agent/talk/message.h"
#include "agent/world/ball_track.h"
#include "agent/world/beliefs.h"
#include "agent/world/config.h"
#include "agent/world/player_tracks.h"

namespace k3d::agent::world {

class WorldModel {
  public:
    /// `team` is the name given to the server: it tells mates from opponents.
    WorldModel(const WorldConfig& world, const localisation::LocalisationConfig& localisation,
               std::uint64_t seed, std::string team);

    /// One cycle: `body` is motion's state after sensing this same frame, `messages` what was heard
    /// in it. All is forgotten when time jumps or a new match begins (BeforeKickOff after another
    /// mode).
    const Beliefs& update(const wire::Percepts& percepts, const motion::State& body,
                          std::span<const talk::Message> messages);

    const Beliefs& beliefs() const { return beliefs_; }

  private:
    void reset();
    void follow_game(const wire::Percepts& percepts);
    void locate(const perception::View* view, const motion::State& body, double dt);
    void see(const perception::View& view);
    void look_for_ball(const perception::View& view);
    void hear(std::span<const talk::Message> messages);

    perception::Identity identity_;
    perception::View view_;
    localisation::Localiser localiser_;
    BallTrack ball_;
    PlayerTracks players_;
    Beliefs beliefs_;
    bool started_ = false;
};

}  // namespace k3d::agent::world
