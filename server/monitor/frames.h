// SPDX-License-Identifier: BSD-3-Clause
// The frames that monitors and logs get: full ones, and differences to the one before (reference 8).
//
//   frame := ((name value...)...)(RSG 0 1)(node...)     full
//          | ((name value...)...)(RDS 0 1)(node...)     what changed since the last difference
//
// Numbers have six significant digits. A difference repeats the tree's shape, since readers match
// nodes by position; it holds a transform only if an element moved by more than 0.005 since a
// difference or a restart told it last. A reader of differences may be off by that much; one who got
// a full frame in between, which is exact but not what later differences build on, by twice that.
#pragma once

#include <optional>
#include <string>

#include "server/game/state.h"
#include "server/monitor/scene_graph.h"

namespace k3d::server::monitor {

/// What of the game is told.
struct GameView {
    double time = 0.0;
    std::string team_left, team_right;  ///< empty: not told
    int half = 1;
    int score_left = 0, score_right = 0;
    game::PlayMode mode = game::PlayMode::BeforeKickOff;
    double half_time = 300.0;  ///< s, in full frames
    double pass_wait_left = 0.0, pass_wait_right = 0.0;  ///< s; told while they run
};

GameView view_of(const game::GameState& state, double half_time);

/// Composes the frames of one group of readers that are all told of every change.
class Frames {
  public:
    /// True if the graph's structure is another than at the last call: then nothing less than a full
    /// frame will do for any reader, and the next difference builds on the present state.
    bool restart(const SceneGraph& graph, const GameView& view);

    std::string full(const SceneGraph& graph, const GameView& view) const;
    /// The difference to the difference before, or to the restart.
    std::string difference(const SceneGraph& graph, const GameView& view);

  private:
    bool tell(std::size_t node, const SceneGraph& graph);

    int revision_ = 0;                ///< of the graph told last, 0 = none
    std::vector<Matrix> transforms_;  ///< as told last, by node
    std::vector<bool> visible_;
    GameView game_;
};

}  // namespace k3d::server::monitor
