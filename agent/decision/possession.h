// SPDX-License-Identifier: BSD-3-Clause
// Getting possession of the ball as a complex behaviour (paper 4): INTERCEPT, GO_TO_FINISH,
// POSITION and HOLD over six state variables, chosen by rules or by a network from a file.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "agent/decision/behaviour.h"
#include "agent/decision/config.h"
#include "agent/motion/motion.h"
#include "agent/skills/go_to.h"
#include "agent/skills/kick_position.h"
#include "agent/world/beliefs.h"
#include "common/random/stream.h"

namespace k3d::agent::decision {

/// What the behaviour decides on, team frame.
struct PossessionInput {
    const world::Beliefs& beliefs;
    const motion::State& body;
    Vec2 target = Vec2::Zero();      ///< where the ball shall be kicked
    double pressure = 0.0;           ///< 0..1, see skills::KickSituation
    bool may_kick = false;
    bool committed = false;          ///< see skills::KickSituation
    double half_area = 1e9;          ///< INTERCEPT and GO_TO_FINISH keep |x|, |y| below this, m
    std::span<const skills::Obstacle> robots;
};

enum PossessionState { kIntercept = 0, kGoToFinish = 1, kPosition = 2, kHold = 3 };
inline constexpr std::size_t kPossessionStates = 4;

/// State variables of paper 4.1 in the order of the network's inputs: three distances, m;
/// angle(ball, agent, finish) and angle(target, agent), degrees (paper-notes: the latter between
/// heading and direction to the target); distance to the ball less the one to the ball 0.5 s ago.
inline constexpr std::array<std::string_view, 6> kPossessionInputs{
    "agent_ball", "agent_finish", "ball_finish", "ball_agent_finish_deg", "target_agent_deg",
    "approach"};
/// The network's outputs, in the order of PossessionState.
inline constexpr std::array<std::string_view, kPossessionStates> kPossessionOutputs{
    "intercept", "go_to_finish", "position", "hold"};
using PossessionVariables = std::array<double, kPossessionInputs.size()>;
PossessionVariables possession_variables(const PossessionInput& input);

/// The hand-written chooser.
int choose_by_rules(const PossessionVariables& variables, int state,
                    const PossessionConfig& config);

using PossessionBehaviour = ComplexBehaviour<PossessionInput, motion::BodyRequest>;

/// `chances` decide for the chooser "random". Throws network::NetworkError if the configured network
/// is missing, damaged or of another shape.
PossessionBehaviour make_possession(const PossessionConfig& config, const skills::SkillConfig& skill,
                                    const skills::KickGeometry& kick, RandomStream chances);

}  // namespace k3d::agent::decision
