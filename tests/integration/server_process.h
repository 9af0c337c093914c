// SPDX-License-Identifier: BSD-3-Clause
// A real k3d-server process and plain wire clients, for tests over real sockets.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "common/net/net.h"
#include "common/process/child.h"
#include "common/wire/commands.h"
#include "common/wire/frame.h"
#include "common/wire/percepts.h"

namespace k3d::testing {

inline constexpr std::chrono::seconds kPatience{30};

/// Nobody waits for who has no seat yet: so many frames may lie in its socket before the one that
/// answers its init. In sync and realtime they are ten seconds of a busy machine; at a fast pace
/// thousands come in a second, and a test wants fast_with_one_agent().
inline constexpr int kMostFramesToSeat = 500;

/// Flags of a fast server that goes on when its one agent has answered, and only then: it stands
/// still in its lobby until that one is waited for, see WireAgent::begin_match().
std::vector<std::string> fast_with_one_agent(std::vector<std::string> more = {});

/// Exit code (-1: it did not end in time, and was killed) and all that it printed of a program of
/// ours that ends by itself.
std::pair<int, std::string> run_to_end(const std::string& program, std::vector<std::string> flags);

/// Started on free ports, ended with the object; of a test that failed its log stays.
class ServerProcess {
  public:
    explicit ServerProcess(std::vector<std::string> flags);
    ServerProcess(const ServerProcess&) = delete;
    ServerProcess& operator=(const ServerProcess&) = delete;
    ~ServerProcess();

    std::uint16_t agent_port() const { return agent_port_; }
    std::uint16_t trainer_port() const { return trainer_port_; }
    std::string log() const;  ///< what it has printed so far
    process::Child& child() { return child_; }

  private:
    std::string log_file_;
    process::Child child_;
    std::uint16_t agent_port_ = 0;
    std::uint16_t trainer_port_ = 0;
};

/// An agent that a test plays by hand.
class WireAgent {
  public:
    explicit WireAgent(const ServerProcess& server) : client_("127.0.0.1", server.agent_port(), kPatience) {}

    void send(const std::string& payload) { client_.send(payload); }
    /// Next frame decoded; false at the connection's end. Fails the test on damaged frames; throws
    /// net::NetError if none comes in time.
    bool receive(wire::Percepts& percepts, std::chrono::milliseconds patience = kPatience);
    /// scene, percept, init; returns once the frame with the team has come.
    wire::Percepts join(int unum, const std::string& team, int type = 0);
    /// Joins fast_with_one_agent() as number 1, and goes on to the match's first frame: in the
    /// lobby joint rates, beams and trainers' commands are dropped.
    void begin_match(const std::string& team);
    /// Sends the commands with (syn) and reads the next frame.
    wire::Percepts step(const std::string& commands = "");
    const std::string& last_payload() const { return payload_; }

  private:
    net::Client client_;
    std::string payload_;
};

}  // namespace k3d::testing
