// SPDX-License-Identifier: BSD-3-Clause
// Scenario seeds in three pools that cannot overlap: train, validation and test.
#pragma once

#include <cstdint>
#include <string_view>

namespace k3d::optimizer::algorithm {

enum class Pool { Train, Validation, Test };

std::string_view name_of(Pool pool);  ///< "train", "validation", "test"

constexpr int kMaxEpisodes = 1 << 20;  ///< of one candidate in one pool: indices below this

/// Seed of episode `index` in [0, kMaxEpisodes). Train: new seeds each generation, the same for all
/// its candidates (common random numbers). Validation and test: the same in every generation.
/// For one run seed two different (pool, generation, index) never give the same seed, since the map is
/// a bijection and the two highest bits are the pool. Below 2^53: exact in JSON and TOML anywhere.
std::uint64_t scenario_seed(std::uint64_t run_seed, Pool pool, int generation, int index);

}  // namespace k3d::optimizer::algorithm
