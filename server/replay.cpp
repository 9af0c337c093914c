// SPDX-License-Identifier: BSD-3-Clause
// Simulation: a recording instead of sockets and clocks.
#include "server/cycle.h"

namespace k3d::server {

void Simulation::replay(recording::Replay& recording, ReplayOutcome& outcome) {
    while (auto inputs = recording.next_step()) {
        outcome.ended_early = end_;
        if (end_) return;
        outcome.episode = episode_;
        replayed_ = &*inputs;
        step();
        outcome.reached = clock_;
        outcome.differs = state_digest() != inputs->digest;
        if (outcome.differs) return;
        ++outcome.steps;
    }
}

void Simulation::replay_inputs() {
    for (recording::ReplayStep::Arrival& arrival : replayed_->arrivals) {
        const recording::Accepted& accepted = arrival.accepted;
        if (accepted.port == recording::Port::Agent) {
            agents_.push_back(std::make_unique<session::AgentSession>(
                std::move(arrival.connection), accepted.connection));
        } else {
            monitors_.accept(std::move(arrival.connection), accepted.connection, accepted.commands);
        }
    }
    for (const recording::Left& left : replayed_->left) {
        for (const auto& agent : agents_) {
            if (agent->number == left.connection) lose(*agent, left.why);
        }
    }
}

}  // namespace k3d::server
