// SPDX-License-Identifier: BSD-3-Clause
// Either game behind one set of calls.
#pragma once

#include <variant>

#include "server/game/keepaway/keepaway.h"
#include "server/game/soccer/soccer.h"

namespace k3d::server::game {

using Game = std::variant<Soccer, Keepaway>;

inline GameState& state(Game& game) {
    return std::visit([](auto& g) -> GameState& { return g.state(); }, game);
}
inline const GameState& state(const Game& game) {
    return std::visit([](const auto& g) -> const GameState& { return g.state(); }, game);
}
inline void before_step(Game& game, body::Scene& scene) {
    std::visit([&](auto& g) { g.before_step(scene); }, game);
}
inline void after_step(Game& game, body::Scene& scene) {
    std::visit([&](auto& g) { g.after_step(scene); }, game);
}
/// Ends it from outside the rules.
inline void abort(Game& game, episode::Status status, const std::string& reason) {
    std::visit([&](auto& g) { g.abort(status, reason); }, game);
}
/// Without state hash and code version, which the caller knows.
inline episode::Result result(const Game& game) {
    return std::visit([](const auto& g) { return g.result(); }, game);
}
inline bool over(const Game& game) {
    return std::visit([](const auto& g) { return g.over(); }, game);
}
/// Keepaway places its robots itself.
inline bool beam_allowed(const Game& game) {
    const Soccer* soccer = std::get_if<Soccer>(&game);
    return soccer != nullptr && soccer->beam_allowed();
}

}  // namespace k3d::server::game
