// SPDX-License-Identifier: BSD-3-Clause
// Hand-made beliefs for tests of decisions.
#pragma once

#include "agent/decision/keepaway/keeper.h"
#include "agent/world/beliefs.h"

namespace k3d::agent::decision::test {

inline world::Player player(int unum, bool mate, Vec2 position, double now = 0.0) {
    world::Player p;
    p.unum = unum;
    p.mate = mate;
    p.seen = now;
    p.position = position;
    p.lagged = position;
    return p;
}

/// Keeper or taker `unum` at `pose`, who sees a ball at rest.
inline world::Beliefs scene(int unum, Pose2 pose, Vec2 ball, double now = 10.0) {
    world::Beliefs b;
    b.now = now;
    b.self.pose = pose;
    b.self.position_sd = 0.05;
    b.self.yaw_sd = 0.02;
    b.self.localised = true;
    b.ball.known = true;
    b.ball.seen = now;
    b.ball.position = b.ball.finish = b.ball.position_before = ball;
    b.game.play_mode = "PlayOn";
    b.game.unum = unum;
    b.game.side = wire::Side::Left;
    return b;
}

/// A linear evaluation function whose cost is `weight` times feature 1..8.
inline network::Definition prefers(std::size_t feature, double weight) {
    network::Definition d;
    for (const auto name : kFeatureNames) d.inputs.push_back({std::string(name)});
    d.outputs = {"cost"};
    d.nodes = {{"cost", network::Activation::Linear, 0.0}};
    d.links = {{std::string(kFeatureNames[feature - 1]), "cost", weight}};
    return d;
}

/// The cost of K1's targets and that of K3's places, each one feature of f1..f9 times a weight.
inline network::Definition prefers_both(const std::pair<std::string, double>& target,
                                        const std::pair<std::string, double>& place) {
    network::Definition d;
    for (const auto name : kPlaceFeatureNames) d.inputs.push_back({std::string(name)});
    d.outputs = {"cost", "place"};
    d.nodes = {{"cost", network::Activation::Linear, 0.0},
               {"place", network::Activation::Linear, 0.0}};
    d.links = {{target.first, "cost", target.second}, {place.first, "place", place.second}};
    return d;
}

/// A kick from 0.2 m straight behind the ball, possible within 0.4 m, as far as wanted.
inline skills::KickGeometry simple_kick() {
    return {1,
            [](int, double) { return true; },
            [](int, const Vec2& ball, double yaw) {
                return Pose2{ball - direction(yaw) * 0.2, yaw};
            },
            [](const motion::Kick& kick) { return kick.ball.norm() < 0.4; },
            [](double wanted) { return wanted; }};
}

inline talk::Report says(int unum, bool claims, std::optional<Vec2> target, int k2, double heard) {
    talk::Report r;
    r.heard = heard;
    r.message.unum = unum;
    r.message.claims_k1 = claims;
    r.message.target = target;
    r.message.k2 = k2;
    return r;
}

inline bool is_stand(const motion::BodyRequest& r) { return std::holds_alternative<motion::Stand>(r); }
inline bool is_walk(const motion::BodyRequest& r) { return std::holds_alternative<motion::Walk>(r); }
inline bool is_kick(const motion::BodyRequest& r) { return std::holds_alternative<motion::Kick>(r); }

}  // namespace k3d::agent::decision::test
