// SPDX-License-Identifier: BSD-3-Clause
// Streams: same name, same numbers; other names, unrelated numbers; the distributions claimed.
#include "common/random/stream.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace k3d {
namespace {

constexpr int kDraws = 200'000;

struct Moments {
    double mean, deviation;
};

template <class Draw>
Moments moments(const Draw& draw) {
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < kDraws; ++i) {
        const double value = draw();
        sum += value;
        squares += value * value;
    }
    const double mean = sum / kDraws;
    return {mean, std::sqrt(squares / kDraws - mean * mean)};
}

TEST(RandomStream, FollowsFromItsThreeNames) {
    RandomStream a(17, "left.3", "vision.noise");
    RandomStream b(17, "left.3", "vision.noise");
    for (int i = 0; i < 100; ++i) EXPECT_EQ(a.next(), b.next());
}

TEST(RandomStream, GivesTheSameNumbersOnEveryPlatform) {
    RandomStream stream(17, "left.3", "vision.noise");
    EXPECT_EQ(stream.next(), 8885820110978899324ULL);
    EXPECT_EQ(stream.next(), 9144415261299904645ULL);
}

TEST(RandomStream, EachNameMakesAnotherStream) {
    const RandomStream base(17, "ab", "c");
    for (RandomStream other : {RandomStream(18, "ab", "c"), RandomStream(17, "a", "bc"),
                               RandomStream(17, "ab", "d"), RandomStream(17, "abc", "")}) {
        RandomStream copy = base;
        int differing_bits = 0;
        for (int i = 0; i < 1000; ++i) {
            differing_bits += __builtin_popcountll(copy.next() ^ other.next());
        }
        // 64 000 fair coins: mean 32 000, standard deviation 126.
        EXPECT_NEAR(differing_bits, 32'000, 800);
    }
}

TEST(RandomStream, UniformFillsItsRange) {
    RandomStream stream(1, "test", "uniform");
    double low = 1.0;
    double high = 0.0;
    const Moments m = moments([&] {
        const double value = stream.uniform();
        low = std::min(low, value);
        high = std::max(high, value);
        return value;
    });
    EXPECT_GE(low, 0.0);
    EXPECT_LT(low, 1e-4);
    EXPECT_LT(high, 1.0);
    EXPECT_GT(high, 1.0 - 1e-4);
    EXPECT_NEAR(m.mean, 0.5, 0.003);
    EXPECT_NEAR(m.deviation, std::sqrt(1.0 / 12.0), 0.002);
    const Moments wide = moments([&] { return stream.uniform(-3.0, 5.0); });
    EXPECT_NEAR(wide.mean, 1.0, 0.025);
}

TEST(RandomStream, NormalHasMeanDeviationAndTails) {
    RandomStream stream(1, "test", "normal");
    int beyond_two = 0;
    const Moments m = moments([&] {
        const double value = stream.normal();
        beyond_two += std::abs(value) > 2.0 ? 1 : 0;
        return value;
    });
    EXPECT_NEAR(m.mean, 0.0, 0.01);
    EXPECT_NEAR(m.deviation, 1.0, 0.01);
    EXPECT_NEAR(beyond_two / static_cast<double>(kDraws), 0.0455, 0.002);
    const Moments moved = moments([&] { return stream.normal(3.0, 0.25); });
    EXPECT_NEAR(moved.mean, 3.0, 0.003);
    EXPECT_NEAR(moved.deviation, 0.25, 0.003);
}

TEST(RandomStream, BelowIsUnbiased) {
    RandomStream stream(1, "test", "below");
    std::array<int, 7> counts{};
    for (int i = 0; i < kDraws; ++i) ++counts[static_cast<std::size_t>(stream.below(7))];
    // Standard deviation of each count: sqrt(n p (1 - p)) = 157.
    for (const int count : counts) EXPECT_NEAR(count, kDraws / 7.0, 800);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(stream.below(1), 0);
}

}  // namespace
}  // namespace k3d
