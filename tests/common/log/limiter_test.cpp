// SPDX-License-Identifier: BSD-3-Clause
#include "common/log/limiter.h"

#include <gtest/gtest.h>

namespace k3d::log {
namespace {

using namespace std::chrono_literals;

TEST(Limiter, PassesSoManyASecondAndCountsTheRest) {
    Limiter limiter(3);
    const auto start = Limiter::Clock::now();
    int passed = 0;
    for (int i = 0; i < 1000; ++i) passed += limiter.allows(spdlog::level::info, start + i * 100us) ? 1 : 0;
    EXPECT_EQ(passed, 3);
    EXPECT_EQ(limiter.left_out(), 997);
    EXPECT_TRUE(limiter.allows(spdlog::level::warn, start + 100ms)) << "warnings still pass";
    EXPECT_TRUE(limiter.allows(spdlog::level::info, start + 1s)) << "a new second";
    EXPECT_EQ(limiter.left_out(), 0) << "said and forgotten";
}

TEST(Printable, StrangersCannotWriteToATerminalOrFillALine) {
    EXPECT_EQ(printable("(he1 0.1)"), "(he1 0.1)");
    EXPECT_EQ(printable("a\x1B[2J\n\xFF"), "a?[2J??");
    EXPECT_EQ(printable(std::string(200, 'x')), std::string(120, 'x') + "...");
}

}  // namespace
}  // namespace k3d::log
