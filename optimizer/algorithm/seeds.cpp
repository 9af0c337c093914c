// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/seeds.h"

#include "common/log/log.h"
#include "common/random/stream.h"

namespace k3d::optimizer::algorithm {
namespace {

constexpr int kBits = 51;  // of the counter; two more are the pool
constexpr std::uint64_t kMask = (std::uint64_t{1} << kBits) - 1;

/// A permutation of 51-bit numbers: each step has an inverse.
std::uint64_t permute(std::uint64_t x, std::uint64_t key) {
    for (int round = 0; round < 3; ++round) {
        x = (x + (key >> (round * 4))) & kMask;
        x ^= x >> 26U;
        x = (x * 0xBF58476D1CE4E5B9ULL) & kMask;  // odd, hence invertible modulo 2^51
    }
    return x ^ (x >> 25U);
}

}  // namespace

std::string_view name_of(Pool pool) {
    switch (pool) {
        case Pool::Train: return "train";
        case Pool::Validation: return "validation";
        case Pool::Test: return "test";
    }
    return "train";
}

std::uint64_t scenario_seed(std::uint64_t run_seed, Pool pool, int generation, int index) {
    K3D_ASSERT(generation >= 0 && index >= 0 && index < kMaxEpisodes);
    const auto row = static_cast<std::uint64_t>(pool == Pool::Train ? generation : 0);
    const std::uint64_t counter = row * kMaxEpisodes + static_cast<std::uint64_t>(index);
    const std::uint64_t key = RandomStream(run_seed, "optimizer", "scenario.seeds").next();
    return static_cast<std::uint64_t>(pool) << kBits | permute(counter & kMask, key);
}

}  // namespace k3d::optimizer::algorithm
