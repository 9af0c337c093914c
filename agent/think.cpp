// SPDX-License-Identifier: BSD-3-Clause
// One cycle of an agent, stage by stage.
#include "agent/think.h"

#include <fmt/format.h>

#include "agent/action/compose.h"
#include "agent/motion/kick/reach.h"
#include "agent/perception/body_sense.h"
#include "common/log/log.h"

namespace k3d::agent {
namespace {

skills::KickGeometry kick_geometry(const kick::Config& config) {
    using kick::kStrikes;
    const auto strike = [](int number) { return kStrikes[static_cast<std::size_t>(number)]; };
    return {static_cast<int>(kStrikes.size()),
            [=](int number, double distance) { return kick::suits(config, strike(number), distance); },
            [=](int number, const Vec2& ball, double yaw) {
                return kick::stand_pose(config, ball, yaw, strike(number));
            },
            [=](const motion::Kick& wish) { return kick::kick_possible(config, wish); },
            [=](double wanted) { return config.reach_for(wanted); },
            [=](int number) { return kick::stance_share(config, strike(number)); }};
}

decision::PlayerSettings player_settings(const Config& c, const std::string& entity) {
    return {c.role, {c.keepaway, c.keeper, c.evaluation, c.possession, c.skills}, c.taker, c.drill, c.seed, entity};
}

}  // namespace

Mind::Mind(const Config& config, const Seat& seat, const std::string& telemetry_file)
    : config_(config),
      seat_(seat),
      model_(nao::model(config.robot_type)),
      motion_(model_, config_.motion),
      world_(config.world, config.localisation, config.seed, seat.team),
      player_(player_settings(config, fmt::format("{}.{}", seat.team, seat.unum)),
              kick_geometry(motion_.kick_config())),
      telemetry_(telemetry_file, seat.team, config.belief_interval, config.telemetry_targets) {}

void Mind::think(std::string_view payload, std::string& reply) {
    // What the server says, in our units.
    if (const int damaged = wire::decode(payload, percepts_); damaged > 0)
        spdlog::debug("{} expressions not understood at {:.2f} s", damaged, percepts_.time);
    perception::body_sense(percepts_, sense_);

    // The body first: it knows where the camera was when this frame's picture was taken.
    const motion::State& body = motion_.sense(sense_);

    // Ears, eyes and memory: where are we, the ball and the others?
    const std::span<const talk::Message> heard =
        ears_.hear(percepts_, seat_.team, world_.beliefs().game.unum);
    const world::Beliefs& beliefs = world_.update(percepts_, body, heard);

    // What to do about it, and how to move for that.
    const decision::Decision decision = player_.decide(beliefs, body, ears_.latest());
    motion_.act(sense_, decision.request, rates_);

    // One frame out, and an account of why.
    const action::Limits limits{config_.keepaway.keepers, config_.beam || config_.role == "soccer"};
    reply.clear();
    action::compose(model_, rates_, decision, beliefs, limits, unsaid_, commands_);
    wire::encode(commands_, reply);
    telemetry_.record(beliefs, motion_.state(), decision);
}

}  // namespace k3d::agent
