// SPDX-License-Identifier: BSD-3-Clause
// Getting up in the server's physics, from falls to every side and with limbs anywhere.
#include "agent/motion/getup/get_up.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "common/random/stream.h"
#include "contract/engine_rig.h"

namespace k3d::contract {
namespace {

using agent::getup::Config;
using agent::getup::GetUp;
using agent::getup::Lying;
using agent::getup::lying_on;

/// Topples a standing robot: the ankles lean it over, the other joints go anywhere near the stand (rad).
/// `towards` 0 = forward, pi/2 = to its left. False if it stayed up.
bool topple(EngineRig& r, double towards, RandomStream& random, double limbs_sd = 0.25) {
    using enum nao::JointId;
    const nao::JointArray stand = walk_stance(r.rig.model().type);
    r.take(stand, 0.5, 0.2);
    nao::JointArray pose = stand;
    for (double& angle : pose) angle += random.normal(0.0, limbs_sd);
    const double pitch = -0.75 * std::cos(towards);
    const double roll = 0.6 * std::sin(towards);
    for (const auto id : {RAnklePitch, LAnklePitch}) pose[nao::index(id)] += -pitch;
    for (const auto id : {RAnkleRoll, LAnkleRoll}) pose[nao::index(id)] += roll;
    for (const auto id : {RHipRoll, LHipRoll}) pose[nao::index(id)] += -0.5 * roll;
    r.take(pose, random.uniform(0.1, 0.3), 0.0);
    for (int n = 0; n < 75 && !r.rig.fallen(); ++n) r.advance();
    const bool down = r.rig.fallen();
    // Getting up may be called for in the middle of the fall or long after it.
    const int wait = random.below(60);
    for (int n = 0; n < wait; ++n) r.advance();
    return down;
}

/// Up within 5 s, and a second later still standing in the stand.
bool gets_up(EngineRig& r) {
    const int type = r.rig.model().type;
    GetUp get_up{Config{}, type};
    get_up.start(walk_stance(type));
    if (r.run(get_up, 5.0) >= 5.0) return false;
    r.take(walk_stance(type), 0.0, 1.0);
    return r.rig.tilt() < radians(15.0) && r.rig.height() > 0.3;
}

TEST(GetUpContract, StandsAgainAfterFallsToEverySide) {
    RandomStream random(1, "get_up_test", "falls");
    std::array<int, 5> seen{};
    int falls = 0;
    int up = 0;
    for (int n = 0; n < 64; ++n) {
        EngineRig r;
        if (!topple(r, 2.0 * kPi * n / 64.0, random)) continue;
        ++falls;
        ++seen[static_cast<std::size_t>(lying_on(r.posture().up))];
        if (gets_up(r)) ++up;
    }
    EXPECT_GT(falls, 40) << "the test must make robots fall";
    EXPECT_GT(seen[static_cast<std::size_t>(Lying::OnBack)], 5);
    EXPECT_GT(seen[static_cast<std::size_t>(Lying::OnFront)], 5);
    EXPECT_GT(seen[static_cast<std::size_t>(Lying::OnRight)], 1);
    EXPECT_GT(seen[static_cast<std::size_t>(Lying::OnLeft)], 1);
    EXPECT_GE(up, falls - 1) << "of " << falls;
}

class EachType : public testing::TestWithParam<int> {};

TEST_P(EachType, StandsAgainAfterAStiffFallAndNoLimbFreezes) {
    RandomStream random(2, "get_up_test", "types");
    for (int n = 0; n < 8; ++n) {
        EngineRig r(GetParam());
        ASSERT_TRUE(topple(r, n % 2 == 0 ? 0.0 : kPi, random, 0.03)) << n;
        const int frozen_before = r.times_frozen();
        EXPECT_TRUE(gets_up(r)) << n;
        EXPECT_EQ(r.times_frozen(), frozen_before) << n;
    }
}

INSTANTIATE_TEST_SUITE_P(GetUpContract, EachType, testing::Range(0, 5));

TEST(GetUpContract, ComesToTheStandWhenItHasNotFallen) {
    EngineRig r;
    r.take(walk_stance(), 0.5, 0.2);
    EXPECT_TRUE(gets_up(r));
}

TEST(GetUpContract, FindsTheSideItLiesOn) {
    EXPECT_EQ(lying_on({0, 0, 1}), Lying::Upright);
    EXPECT_EQ(lying_on({1, 0, 0}), Lying::OnBack);
    EXPECT_EQ(lying_on({-1, 0, 0.1}), Lying::OnFront);
    EXPECT_EQ(lying_on({0, 1, 0}), Lying::OnRight);
    EXPECT_EQ(lying_on({0.2, -0.97, 0}), Lying::OnLeft);
}

}  // namespace
}  // namespace k3d::contract
