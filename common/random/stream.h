// SPDX-License-Identifier: BSD-3-Clause
// Named random streams: each consumer draws from its own, so that one more draw here never shifts
// the numbers drawn elsewhere. Streams give the same numbers on every platform; hence no <random>
// distributions, whose sequences the standard leaves open.
#pragma once

#include <cstdint>
#include <string_view>

namespace k3d {

/// A stream is fixed by (seed, entity, purpose), e.g. (17, "left.3", "vision.noise").
/// Generator: SplitMix64 seeded by XXH3 of the three; 2^64 period, passes BigCrush.
class RandomStream {
  public:
    RandomStream(std::uint64_t seed, std::string_view entity, std::string_view purpose);

    std::uint64_t next();                         ///< 64 uniform bits
    double uniform();                             ///< [0, 1)
    double uniform(double low, double high);      ///< [low, high)
    double normal();                              ///< mean 0, standard deviation 1 (Box-Muller)
    double normal(double mean, double deviation);
    int below(int count);                         ///< 0 .. count-1, unbiased; count >= 1

  private:
    std::uint64_t state_;
    double spare_ = 0.0;
    bool has_spare_ = false;
};

}  // namespace k3d
