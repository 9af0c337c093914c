// SPDX-License-Identifier: BSD-3-Clause
// One command frame, agent to server: effectors of SimSpark reference 4, with both codecs.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/nao/model.h"

namespace k3d::wire {

struct SceneCommand {  ///< `(scene rsg/agent/nao/nao_hetero.rsg 3)`
    std::string file;
    std::vector<std::string> arguments;
};

struct InitCommand {  ///< `(init (unum 3)(teamname Reds))`; 0 asks for any free number
    int unum = 0;
    std::string team;
};

struct BeamCommand {  ///< `(beam x y a)`: m, m, deg in the team's frame
    double x = 0.0, y = 0.0, angle_deg = 0.0;
};

/// All commands of one or more frames; a later value for the same joint, beam, init or scene wins.
struct Commands {
    std::array<std::optional<double>, nao::kJointCount> joint_rates;  ///< rad/s, finite, by JointId
    std::optional<SceneCommand> scene;
    std::optional<InitCommand> init;
    std::optional<BeamCommand> beam;
    std::vector<std::string> say;  ///< in order; length and bytes are judged by the server's say effector
    bool syn = false;
    bool pass = false;
};

/// Appends the payload to `out`: joints first, then scene, init, beam, say, pass, syn last.
void encode(const Commands& commands, std::string& out);

/// Adds the commands of a payload to `commands` (not reset). Unknown predicates (`proxy`, ...) are
/// skipped, damaged ones and non-finite numbers dropped; the number of both is returned. After an
/// unbalanced parenthesis the complete expressions before it still count. No input makes it throw.
int decode(std::string_view payload, Commands& commands);

}  // namespace k3d::wire
