// SPDX-License-Identifier: BSD-3-Clause
// What the exact physics of a match costs by itself: five robots play keepaway in one process, then the
// same joint speeds are given to the same robots in a bare loop of collision and dWorldStep.
// usage: bare_step SEED [SECONDS]     prints cycles and processor time per cycle, us
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "common/clock/clock.h"
#include "contract/minds_rig.h"

namespace {

using namespace k3d;

constexpr double kPlaying = 3.5;  // s, when everybody stands and the ball is in play

using Rates = std::array<std::optional<double>, nao::kJointCount>;

/// What moved the robots, cycle by cycle, and from where.
struct Played {
    std::vector<server::physics::BodyState> start;
    std::vector<std::vector<Rates>> rates;  ///< by cycle and robot
};

Played play(std::uint64_t seed, double seconds) {
    contract::MindsRig match(3, 2, seed);
    while (match.time() < kPlaying) match.step();
    Played played{match.scene().world.state(), {}};
    while (!match.over() && match.time() < kPlaying + seconds) {
        match.step();
        auto& cycle = played.rates.emplace_back();
        for (const auto& seat : match.seats()) {
            auto& rates = cycle.emplace_back();
            for (std::size_t j = 0; j < rates.size(); ++j) rates[j] = seat.commands.joint_rates[j];
        }
    }
    return played;
}

double processor_seconds() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double bare_seconds(const Played& played) {
    server::body::Scene scene;
    const std::size_t robots = played.rates.front().size();
    for (std::size_t k = 0; k < robots; ++k) scene.add_player(0, {0.0, 0.0, 1.0});
    scene.world.set_state(played.start);
    double spent = 0.0;
    for (const auto& cycle : played.rates) {
        for (std::size_t k = 0; k < robots; ++k) {
            for (std::size_t j = 0; j < nao::kJointCount; ++j) {
                if (!cycle[k][j]) continue;
                scene.players[k]->robot->drive(static_cast<nao::JointId>(j), *cycle[k][j]);
            }
        }
        const double before = processor_seconds();
        scene.world.step();
        spent += processor_seconds() - before;
    }
    return spent;
}

}  // namespace

int main(int argc, char** argv) {
    const double seconds = argc > 2 ? std::atof(argv[2]) : 15.0;
    if (argc < 2 || argc > 3 || seconds <= 0.0) {
        std::fprintf(stderr, "usage: bare_step SEED [SECONDS]\n");
        return 2;
    }
    const Played played = play(std::strtoull(argv[1], nullptr, 10), seconds);
    const auto cycles = static_cast<double>(played.rates.size());
    std::printf("%zu %.1f\n", played.rates.size(), 1e6 * bare_seconds(played) / cycles);
    return 0;
}
