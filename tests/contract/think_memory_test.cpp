// SPDX-License-Identifier: BSD-3-Clause
// An agent's cycle takes no memory once it has played for a while: nothing grows, nothing waits for
// the allocator. Allocations are counted in operator new, of this program alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <new>

#include "contract/minds_rig.h"

namespace {

bool counting = false;
long allocations = 0;

}  // namespace

void* operator new(std::size_t size) {
    if (counting) ++allocations;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace k3d::contract {
namespace {

constexpr double kSettled = 8.0;  // s: 3 before kick-off, and all have begun to play

TEST(ThinkMemory, NoAllocationOnceThePlayRuns) {
    long cycles = 0;
    double counted = 0.0;  // s of play, of as many matches as it takes
    for (std::uint64_t seed = 1; counted < 20.0 && seed <= 20; ++seed) {
        MindsRig match(3, 2, seed);
        const auto think = [&](MindsRig::Seat& seat) {
            counting = match.time() > kSettled;
            seat.mind->think(seat.payload, seat.reply);
            cycles += counting ? 1 : 0;
            counting = false;
        };
        while (match.time() < 30.0 && !match.over()) match.step(think);
        counted += std::max(0.0, match.time() - kSettled);
    }
    EXPECT_GT(counted, 20.0) << "seen playing";
    EXPECT_EQ(allocations, 0) << "in " << cycles << " cycles";
}

}  // namespace
}  // namespace k3d::contract
