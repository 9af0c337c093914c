// SPDX-License-Identifier: BSD-3-Clause
// A match of keepaway in one process: the server's bodies, senses and rules, and real agents'
// minds, with the wire's text between them but no sockets. Deterministic.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "agent/think.h"
#include "common/wire/commands.h"
#include "common/wire/percepts.h"
#include "server/effectors/hearing.h"
#include "server/game/keepaway/keepaway.h"
#include "server/percepts/senses.h"

namespace k3d::contract {

class MindsRig {
  public:
    struct Seat {
        int id = 0;  ///< of the player in the scene
        std::unique_ptr<server::percepts::Senses> senses;
        std::unique_ptr<agent::Mind> mind;
        server::effectors::Ear ear;
        wire::Percepts percepts;
        std::string payload;  ///< of the frame it got last
        std::string reply;
        wire::Commands commands;
        bool told = false;
    };

    MindsRig(int keepers, int takers, std::uint64_t seed);

    /// One cycle. `think` is called once per agent in place of seat.mind->think(seat.payload, seat.reply).
    void step(const std::function<void(Seat&)>& think);
    void step() {
        step([](Seat& seat) { seat.mind->think(seat.payload, seat.reply); });
    }

    double time() const { return time_; }
    bool over() const { return game_.over(); }
    server::body::Scene& scene() { return *scene_; }
    std::vector<Seat>& seats() { return seats_; }

  private:
    void tell(Seat& seat);
    void obey(Seat& seat);

    server::game::KeepawayConfig config_;
    std::unique_ptr<server::body::Scene> scene_;
    server::game::Keepaway game_;
    std::vector<Seat> seats_;
    double time_ = 0.0;
};

}  // namespace k3d::contract
