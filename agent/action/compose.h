// SPDX-License-Identifier: BSD-3-Clause
// The reply to one percept frame: joint speeds, a beam before kick-off, what to say, `(syn)` last.
#pragma once

#include <string>

#include "agent/decision/decision.h"
#include "agent/world/beliefs.h"
#include "common/nao/model.h"
#include "common/wire/commands.h"

namespace k3d::agent::action {

struct Limits {
    int keepers = 3;    ///< players who share the turns to speak
    bool beam = false;  ///< beam before kick-off and after goals
};

/// Fills `commands`, which is reset first; its memory is used again, and `unsaid` keeps that of the
/// text between two turns to speak. `rates` in rad/s. A message is said only in this player's turn
/// (talk/slots.h).
void compose(const nao::Model& model, const nao::JointArray& rates,
             const decision::Decision& decision, const world::Beliefs& beliefs,
             const Limits& limits, std::string& unsaid, wire::Commands& commands);

/// Where player `unum` beams to: in the own half, looking at the opponents' goal; team frame.
wire::BeamCommand kick_off_beam(int unum);

}  // namespace k3d::agent::action
