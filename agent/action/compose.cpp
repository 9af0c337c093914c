// SPDX-License-Identifier: BSD-3-Clause
// From decision and joint speeds to commands.
#include "agent/action/compose.h"

#include "agent/decision/soccer/formation.h"
#include "agent/talk/slots.h"

namespace k3d::agent::action {

wire::BeamCommand kick_off_beam(int unum) {
    const Vec2 place = decision::kick_off_place(unum);
    return {place.x(), place.y(), 0.0};
}

void compose(const nao::Model& model, const nao::JointArray& rates,
             const decision::Decision& decision, const world::Beliefs& b, const Limits& limits,
             std::string& unsaid, wire::Commands& commands) {
    commands.joint_rates = {};
    commands.beam.reset();
    for (const nao::JointDef& joint : model.joints)
        commands.joint_rates[nao::index(joint.id)] = rates[nao::index(joint.id)];
    const bool may_beam = b.game.play_mode == "BeforeKickOff" || b.game.play_mode == "Goal_Left" ||
                          b.game.play_mode == "Goal_Right";
    if (limits.beam && may_beam && b.game.unum > 0) commands.beam = kick_off_beam(b.game.unum);
    const bool speaks = decision.say && talk::may_speak(b.now, b.game.unum, limits.keepers);
    if (!commands.say.empty()) unsaid.swap(commands.say.front());
    commands.say.clear();
    if (speaks) {
        commands.say.push_back(std::move(unsaid));
        talk::encode(*decision.say, commands.say.front());
    }
    commands.syn = true;
}

}  // namespace k3d::agent::action
