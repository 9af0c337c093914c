// SPDX-License-Identifier: BSD-3-Clause
// One keeper against one taker who answer whatever comes, each in a thread of its own, and a
// trainer in the barrier: tests say what the trainer does, turn by turn, and when a player leaves.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include "common/episode/result.h"
#include "integration/server_process.h"

namespace k3d::testing {

/// Plays one seat until the server closes, or until `stays` says no: then it closes its connection.
class Puppet {
  public:
    using Stays = std::function<bool(const wire::Percepts&)>;

    Puppet(const ServerProcess& server, const std::string& team, Stays stays)
        : thread_([&server, team, stays = std::move(stays)] {
              try {
                  play(server, team, stays);
              } catch (const net::NetError&) {
                  // The server has ended, or has nothing to say any more: the test looks at why.
              }
          }) {}
    ~Puppet() { thread_.join(); }
    Puppet(const Puppet&) = delete;
    Puppet& operator=(const Puppet&) = delete;

  private:
    static void play(const ServerProcess& server, const std::string& team, const Stays& stays) {
        WireAgent agent(server);
        wire::Percepts percepts;
        agent.send("(scene rsg/agent/nao/nao.rsg)(syn)");
        if (!agent.receive(percepts)) return;
        agent.send("(init (unum 1)(teamname " + team + "))(syn)");
        for (int k = 0; agent.receive(percepts) && stays(percepts); ++k) {
            agent.send(k % 20 < 10 ? "(lle3 1.5)(rae1 -2)(syn)" : "(lle3 -1.5)(rae1 2)(syn)");
        }
    }

    std::thread thread_;
};

/// What the game looks like to who says when it is over.
inline bool always(const wire::Percepts&) {
    return true;
}
inline bool until_the_whistle(const wire::Percepts& percepts) {
    return !percepts.game || percepts.game->play_mode != "GameOver";
}

/// Keepaway on a server of its own, in PlayOn from the trainer's fourth turn on; a turn is two
/// cycles.
class PuppetGame {
  public:
    /// `device`: where the rows go, in place of a file.
    explicit PuppetGame(const std::string& name, std::vector<std::string> flags = {},
                        const Puppet::Stays& taker_stays = always, const std::string& device = "")
        : results_(std::filesystem::temp_directory_path() /
                   ("k3d-puppets-" + name + "-" + std::to_string(getpid()) + ".jsonl")),
          server_(with_own(results_, device, std::move(flags))),
          trainer_("127.0.0.1", server_.trainer_port(), kPatience) {
        std::string_view greeting;
        EXPECT_TRUE(trainer_.receive(greeting, kPatience));
        trainer_.send("(syn)");  // answers the first turn; nobody plays before it is heard
        keeper_.emplace(server_, "Keepers", always);
        taker_.emplace(server_, "Takers", taker_stays);
    }
    ~PuppetGame() {
        server_.child().kill();  // puppets that still wait go home
        std::filesystem::remove(results_);
    }

    /// Waits for the trainer's next turn and answers it; false once the server has closed.
    bool turn(const std::string& commands = "") {
        try {
            std::string_view frame;
            while (trainer_.receive(frame, kPatience)) {
                if (frame.find("(syn 1)") == std::string_view::npos) continue;
                trainer_.send(commands + "(syn)");
                return true;
            }
        } catch (const net::NetError&) {
        }
        return false;
    }
    void turns(int count) {
        for (int i = 0; i < count; ++i) EXPECT_TRUE(turn());
    }
    /// The server's exit code; -1 if the game does not come to an end.
    int play_to_the_end() {
        for (int i = 0; i < 5000 && turn(); ++i) {
        }
        const auto exit = server_.child().wait(kPatience);
        return exit ? exit->code : -1;
    }
    std::vector<episode::Result> results() const {
        std::vector<episode::Result> all;
        std::ifstream file(results_);
        for (std::string line; std::getline(file, line);) all.push_back(episode::from_line(line));
        return all;
    }
    ServerProcess& server() { return server_; }

  private:
    static std::vector<std::string> with_own(const std::filesystem::path& results,
                                             const std::string& device,
                                             std::vector<std::string> flags) {
        std::filesystem::remove(results);
        if (!device.empty()) std::filesystem::create_symlink(device, results);
        flags.insert(flags.begin(),
                     {"--game", "keepaway", "--pace", "fast", "--keepers", "1", "--takers", "1",
                      "--left-team", "Keepers", "--set", "keepaway.before_kick_off=0.1",
                      "--results", results.string()});
        return flags;
    }

    std::filesystem::path results_;
    ServerProcess server_;
    net::Client trainer_;
    std::optional<Puppet> keeper_, taker_;
};

}  // namespace k3d::testing
