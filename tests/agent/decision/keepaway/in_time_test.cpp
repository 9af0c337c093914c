// SPDX-License-Identifier: BSD-3-Clause
// Tests of leaving out targets that come too late.
#include "agent/decision/keepaway/in_time.h"

#include <gtest/gtest.h>

namespace k3d::agent::decision {
namespace {

/// Four targets on a line; K1 needs as many seconds for one as it is metres away.
const std::vector<Vec2> kGrid{{1.0, 0.0}, {2.0, 0.0}, {3.0, 0.0}, {4.0, 0.0}};
const auto kReady = [](const Vec2& point) { return point.x(); };
const Room kRoom = [](const Vec2&) { return 1.0; };

std::vector<Vec2> in_time(double deadline, double patience, const Room& room = kRoom) {
    std::vector<Vec2> out;
    targets_in_time(kGrid, room, {deadline, patience, kReady}, out);
    return out;
}

TEST(TargetsInTime, KeepsThoseBeforeTheDeadlineInTheirOrder) {
    EXPECT_EQ(in_time(9.0, 0.0), kGrid);
    EXPECT_EQ(in_time(2.5, 0.0), (std::vector<Vec2>{kGrid[0], kGrid[1]}));
}

TEST(TargetsInTime, TakesTheSoonestWhenAllAreTooLate) {
    EXPECT_EQ(in_time(0.0, 0.1), (std::vector<Vec2>{kGrid[0]}));
    EXPECT_EQ(in_time(-5.0, 1.5), (std::vector<Vec2>{kGrid[0], kGrid[1]}));
}

TEST(TargetsInTime, WhatHasNoRoomIsNoTargetHoweverSoon) {
    const Room far_only = [](const Vec2& point) { return point.x() - 2.5; };
    EXPECT_EQ(in_time(0.0, 0.1, far_only), (std::vector<Vec2>{kGrid[2]}));
    EXPECT_TRUE(in_time(9.0, 0.0, [](const Vec2&) { return -1.0; }).empty());
}

}  // namespace
}  // namespace k3d::agent::decision
