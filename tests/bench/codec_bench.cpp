// SPDX-License-Identifier: BSD-3-Clause
// The wire's text: frames of a running match, and what trainers send.
#include <benchmark/benchmark.h>

#include <vector>

#include "common/wire/commands.h"
#include "common/wire/percepts.h"
#include "common/wire/trainer.h"
#include "contract/minds_rig.h"

namespace k3d::bench {
namespace {

/// Frames with and without vision, as one keeper got them, and what it replied.
struct Frames {
    std::vector<wire::Percepts> percepts;
    std::vector<std::string> payloads;
    std::vector<std::string> replies;
};

const Frames& frames() {
    static const Frames recorded = [] {
        contract::MindsRig match(3, 2, 2);
        Frames f;
        while (match.time() < 4.0) match.step();
        for (int k = 0; k < 300; ++k) {
            match.step();
            const auto& seat = match.seats().front();
            f.percepts.push_back(seat.percepts);
            f.payloads.push_back(seat.payload);
            f.replies.push_back(seat.reply);
        }
        return f;
    }();
    return recorded;
}

template <class Work>
void over_frames(benchmark::State& state, const std::vector<std::string>& texts, Work work) {
    std::size_t k = 0;
    std::int64_t bytes = 0;
    for (auto _ : state) {
        work(k);
        bytes += static_cast<std::int64_t>(texts[k].size());
        k = (k + 1) % texts.size();
    }
    state.SetBytesProcessed(bytes);
}

void PerceptEncode(benchmark::State& state) {
    std::string out;
    over_frames(state, frames().payloads, [&out](std::size_t k) {
        out.clear();
        wire::encode(frames().percepts[k], nao::model(0), out);
        benchmark::DoNotOptimize(out.data());
    });
}
BENCHMARK(PerceptEncode);

void PerceptDecode(benchmark::State& state) {
    wire::Percepts percepts;
    over_frames(state, frames().payloads, [&percepts](std::size_t k) {
        benchmark::DoNotOptimize(wire::decode(frames().payloads[k], percepts));
    });
}
BENCHMARK(PerceptDecode);

void CommandDecode(benchmark::State& state) {
    wire::Commands commands;
    over_frames(state, frames().replies, [&commands](std::size_t k) {
        commands.say.clear();
        benchmark::DoNotOptimize(wire::decode(frames().replies[k], commands));
    });
}
BENCHMARK(CommandDecode);

void CommandEncode(benchmark::State& state) {
    wire::Commands commands;
    wire::decode(frames().replies.front(), commands);
    std::string out;
    for (auto _ : state) {
        out.clear();
        wire::encode(commands, out);
        benchmark::DoNotOptimize(out.data());
    }
}
BENCHMARK(CommandEncode);

void TrainerDecode(benchmark::State& state) {
    const std::string text =
        "(ball (pos -3.2 1.5 0.04)(vel 1 0 0))(agent (unum 3)(team Left)(move 1 2 0.4 90))(syn)";
    std::vector<wire::TrainerCommand> commands;
    for (auto _ : state) {
        commands.clear();
        benchmark::DoNotOptimize(wire::decode(text, commands));
    }
}
BENCHMARK(TrainerDecode);

}  // namespace
}  // namespace k3d::bench
