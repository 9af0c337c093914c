// SPDX-License-Identifier: BSD-3-Clause
// The stages of a match in one process, without sockets: an agent's cycle, the senses, and the
// physics of five robots that walk, against a bare world step of each stepper.
#include <benchmark/benchmark.h>

#include <chrono>

#include "contract/minds_rig.h"

namespace k3d::bench {
namespace {

using Clock = std::chrono::steady_clock;
using Seat = contract::MindsRig::Seat;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A match that has just begun to play; the next one when it is over.
class Running {
  public:
    contract::MindsRig& match() {
        if (!match_ || match_->over() || match_->time() > 60.0) {
            match_ = std::make_unique<contract::MindsRig>(3, 2, seed_++);
            while (match_->time() < 3.5) match_->step();
        }
        return *match_;
    }

  private:
    std::unique_ptr<contract::MindsRig> match_;
    std::uint64_t seed_ = 1;
};

/// Mean time of one agent's cycle, from payload to reply.
void Think(benchmark::State& state) {
    Running running;
    for (auto _ : state) {
        double spent = 0.0;
        contract::MindsRig& match = running.match();
        match.step([&spent](Seat& seat) {
            const auto start = Clock::now();
            seat.mind->think(seat.payload, seat.reply);
            spent += seconds_since(start);
        });
        state.SetIterationTime(spent / static_cast<double>(match.seats().size()));
    }
}
BENCHMARK(Think)->UseManualTime()->Unit(benchmark::kMicrosecond)->Iterations(5000);

/// A frame's senses for one agent, without text.
void Sense(benchmark::State& state) {
    Running running;
    contract::MindsRig& match = running.match();
    Seat& seat = match.seats().front();
    double time = match.time();
    for (auto _ : state) {
        time += 0.02;
        seat.senses->after_step(match.scene(), *match.scene().find(seat.id), time, seat.percepts);
        benchmark::DoNotOptimize(seat.percepts);
    }
}
BENCHMARK(Sense)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace k3d::bench
