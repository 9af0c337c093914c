// SPDX-License-Identifier: BSD-3-Clause
#include "common/random/stream.h"

#include <xxhash.h>

#include <cmath>
#include <string>

#include "common/math/geometry.h"

namespace k3d {

RandomStream::RandomStream(std::uint64_t seed, std::string_view entity, std::string_view purpose) {
    std::string key(entity);
    key += '\0';  // keeps ("ab", "c") and ("a", "bc") apart
    key += purpose;
    state_ = XXH3_64bits_withSeed(key.data(), key.size(), seed);
}

std::uint64_t RandomStream::next() {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
}

double RandomStream::uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

double RandomStream::uniform(double low, double high) { return low + (high - low) * uniform(); }

double RandomStream::normal() {
    if (has_spare_) {
        has_spare_ = false;
        return spare_;
    }
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    const double angle = 2.0 * kPi * uniform();
    spare_ = radius * std::sin(angle);
    has_spare_ = true;
    return radius * std::cos(angle);
}

double RandomStream::normal(double mean, double deviation) { return mean + deviation * normal(); }

int RandomStream::below(int count) {
    const auto range = static_cast<std::uint64_t>(count);
    const std::uint64_t limit = ~std::uint64_t{0} - ~std::uint64_t{0} % range;
    std::uint64_t draw = next();
    while (draw >= limit) draw = next();
    return static_cast<int>(draw % range);
}

}  // namespace k3d
