// SPDX-License-Identifier: BSD-3-Clause
// One keeper against one taker, both played by hand, and a trainer in the barrier who ends the game.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "common/episode/result.h"
#include "integration/server_process.h"

namespace k3d::testing {

/// The next frame of a monitor; empty at the connection's end.
inline std::string next_frame(net::Client& monitor) {
    std::string_view frame;
    return monitor.receive(frame, kPatience) ? std::string(frame) : std::string();
}

inline bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// What the trainer says in answer to its nth frame of the match, counted from 1.
using Script = std::map<int, std::string>;

/// Ends the game 24 cycles after its start: the ball leaves the area.
inline const Script kBallOut{{12, "(ball (pos 8 0 0.042))"}};

/// Plays on a server with these flags until it ends; the EpisodeResult.
inline episode::Result play_duel(std::vector<std::string> flags, const Script& script,
                                 const std::string& name) {
    const std::filesystem::path results =
        std::filesystem::temp_directory_path() /
        ("k3d-duel-" + name + "-" + std::to_string(getpid()) + ".jsonl");
    std::filesystem::remove(results);
    flags.insert(flags.end(),
                 {"--game", "keepaway", "--pace", "fast", "--keepers", "1", "--takers", "1",
                  "--set", "keepaway.before_kick_off=0.1", "--results", results.string()});
    ServerProcess server(flags);
    net::Client trainer("127.0.0.1", server.trainer_port(), kPatience);
    EXPECT_TRUE(holds(next_frame(trainer), "(RSG 0 1)"));
    trainer.send("(syn)");
    WireAgent keeper(server), taker(server);
    // Both seats must be taken before either is answered a sixth time.
    for (WireAgent* agent : {&keeper, &taker}) {
        wire::Percepts percepts;
        agent->send("(scene rsg/agent/nao/nao.rsg)(syn)");
        EXPECT_TRUE(agent->receive(percepts));
        agent->send(std::string("(init (unum 1)(teamname ") +
                    (agent == &keeper ? "Keepers" : "Takers") + "))(syn)");
        EXPECT_TRUE(agent->receive(percepts));
    }
    int frame = 0;
    bool running = true;
    for (int received = 2; running && received < 5000; ++received) {
        const bool first_half = received % 20 < 10;
        try {
            keeper.send(first_half ? "(lle3 1.5)(rae1 -2)(syn)" : "(lle3 -1.5)(rae1 2)(syn)");
            taker.send("(he1 0.5)(syn)");
            // Five answers are the lobby's; from then on the trainer is told of every second cycle,
            // and the agents hear more only when it has answered.
            if (received >= 6 && received % 2 == 0) {
                running = holds(next_frame(trainer), "(syn 1)");
                const auto line = script.find(++frame);
                if (running) trainer.send((line == script.end() ? "" : line->second) + "(syn)");
            }
            wire::Percepts percepts;
            running = running && keeper.receive(percepts) && taker.receive(percepts);
        } catch (const net::NetError&) {
            running = false;  // the server ended between two of these
        }
    }
    const auto exit = server.child().wait(kPatience);
    EXPECT_TRUE(exit && exit->code == 0) << server.log();
    std::ifstream file(results);
    std::string line;
    std::getline(file, line);
    std::filesystem::remove(results);
    return episode::from_line(line);
}

}  // namespace k3d::testing
