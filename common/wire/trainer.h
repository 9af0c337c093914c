// SPDX-License-Identifier: BSD-3-Clause
// Trainer commands on the monitor port (SimSpark reference 8.5), with both codecs.
// Coordinates are absolute field coordinates for both teams, none beyond 1000 (m, m/s).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "common/math/geometry.h"
#include "common/wire/percepts.h"

namespace k3d::wire {

struct BallCommand {  ///< `(ball (pos x y z) (vel vx vy vz))`; vel also zeroes the spin
    std::optional<Vec3> position, velocity;
};
struct AgentCommand {  ///< `(agent (unum N)(team Left)(pos ..) | (move x y z a))`
    int unum = 0;
    Side team = Side::None;
    std::optional<Vec3> position;   ///< none if only (battery ..) or (temperature ..) is told
    std::optional<double> yaw_deg;  ///< `move` only: 0 = forward axis along world +y
};
/// `(agent)`: sends the selected players 2.5 m back.
struct ClearSelectedCommand {};
struct PlayModeCommand { std::string mode; };          ///< `(playMode PlayOn)`
struct KickOffCommand { Side side = Side::None; };     ///< `(kickOff Left|Right|None)`
struct DropBallCommand {};                             ///< `(dropBall)`
struct TimeCommand { double time = 0.0; };             ///< `(time T)`, T in 0..1e6
struct ScoreCommand { int left = 0, right = 0; };      ///< `(score (left N)(right M))`, 0..9999
struct KillCommand {   ///< `(kill (unum N)(team Left))`, `(kill)`: the selected player
    int unum = 0;
    Side team = Side::None;
    bool selected = false;
};
struct ReposCommand {  ///< `(repos (unum N)(team Left))`, `(repos)`: the selected player
    int unum = 0;
    Side team = Side::None;
    bool selected = false;
};
struct SelectCommand {  ///< `(select (unum N)(team Left))`, `(select)`, `(select (unum -1))`
    enum class Who { Player, Next, Nobody };
    int unum = 0;
    Side team = Side::None;
    Who who = Who::Player;
};
struct FullStateCommand {};                            ///< `(reqfullstate)`
struct KillSimCommand {};                              ///< `(killsim)`
struct TrainerSynCommand {};                           ///< `(syn)`: this trainer joins the barrier
struct IdleCommand {};  ///< `(init)`, `(getAck ..)`: sent by old viewers, accepted, without effect

using TrainerCommand =
    std::variant<BallCommand, AgentCommand, ClearSelectedCommand, PlayModeCommand, KickOffCommand,
                 DropBallCommand, TimeCommand, ScoreCommand, KillCommand, ReposCommand,
                 SelectCommand, FullStateCommand, KillSimCommand, TrainerSynCommand, IdleCommand>;

void encode(const TrainerCommand& command, std::string& out);

/// Appends the commands of a payload in order; unknown or damaged ones are skipped and counted.
int decode(std::string_view payload, std::vector<TrainerCommand>& commands);

}  // namespace k3d::wire
