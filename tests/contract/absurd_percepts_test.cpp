// SPDX-License-Identifier: BSD-3-Clause
// A mind that has once been told absurd numbers still sends joint speeds: what it remembers from
// cycle to cycle stays finite, whatever comes over the wire.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>

#include "contract/minds_rig.h"

namespace k3d::contract {
namespace {

using testing::HasSubstr;
using testing::Not;

// X is the number. What comes later in a frame replaces what came before.
constexpr std::array<std::string_view, 11> kGroups{
    "(GYR (n torso) (rt X 0 0))",
    "(GYR (n torso) (rt 0 -X X))",
    "(ACC (n torso) (a X X -X))",
    "(HJ (n llj3) (ax X))",
    "(FRP (n lf) (c X 0 0) (f 0 0 X))",
    "(GS (t X) (pm PlayOn))",
    "(See (B (pol X -30 -9)))",
    "(See (G1R (pol X 10 5)) (F1R (pol 8 X 1)) (L (pol X -40 -2) (pol 12 -X X)))",
    "(See (P (team Takers) (id 1) (head (pol X 0 X)) (lfoot (pol -X X 1))))",
    "(hear Keepers X X abc)",
    "(time (now X))",
};

std::string with_number(std::string_view group, std::string_view number) {
    std::string text;
    for (const char c : group) {
        if (c == 'X') {
            text += number;
        } else {
            text += c;
        }
    }
    return text;
}

TEST(AbsurdPercepts, LeaveNoTraceInWhatIsSent) {
    for (const std::string_view number : {"1e300", "1e200", "1e9"}) {
        for (const std::string_view group : kGroups) {
            const std::string absurd = with_number(group, number);
            MindsRig match(1, 1, 1);
            int cycle = 0;
            while (cycle < 200) {  // past the 3 s before kick-off
                ++cycle;
                match.step([&](MindsRig::Seat& seat) {
                    const bool hit = cycle % 60 == 0;
                    seat.mind->think(hit ? seat.payload + absurd : seat.payload, seat.reply);
                    ASSERT_THAT(seat.reply, Not(HasSubstr("nan")))
                        << absurd << " in cycle " << cycle;
                });
                if (HasFatalFailure()) break;
            }
        }
    }
}

}  // namespace
}  // namespace k3d::contract
