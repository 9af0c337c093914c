// SPDX-License-Identifier: BSD-3-Clause
// An agent's cycle takes no memory once it has played for a while: nothing grows, nothing waits for
// the allocator. Allocations are counted in operator new, of this program alone.
#include <gtest/gtest.h>

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

TEST(ThinkMemory, NoAllocationOnceThePlayRuns) {
    MindsRig match(3, 2, 2);
    long cycles = 0;
    const auto think = [&](MindsRig::Seat& seat) {
        counting = match.time() > 8.0;  // 3 s before kick-off, and all have begun to play
        seat.mind->think(seat.payload, seat.reply);
        counting = false;
        ++cycles;
    };
    while (match.time() < 30.0 && !match.over()) match.step(think);
    EXPECT_GT(match.time(), 20.0) << "seen playing";
    EXPECT_EQ(allocations, 0) << "in " << cycles << " cycles";
}

}  // namespace
}  // namespace k3d::contract
