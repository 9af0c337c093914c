// SPDX-License-Identifier: BSD-3-Clause
// Tests of roles: nearest to the finish, head start, K1's word, ties.
#include "agent/decision/keepaway/roles.h"

#include <gtest/gtest.h>

#include "agent/decision/keepaway/scene.h"

namespace k3d::agent::decision {
namespace {

using test::player;
using test::says;
using test::scene;

/// Keeper 1 at `self`, keepers 2 and 3 far away, ball at the origin.
world::Beliefs keeper_at(Vec2 self, Vec2 second, double now = 10.0) {
    world::Beliefs b = scene(1, {self, 0.0}, {0.0, 0.0}, now);
    b.mates = {player(2, true, second), player(3, true, {4.0, 4.0})};
    return b;
}

TEST(Roles, NearestToTheFinishIsK1) {
    RoleKeeper roles;
    const KeeperConfig c;
    EXPECT_EQ(roles.update(keeper_at({1.0, 0.0}, {3.0, 0.0}), {}, c).role, Role::K1);
    world::Beliefs rolling = keeper_at({1.0, 0.0}, {3.0, 0.0});
    rolling.ball.finish = {4.0, 0.0};  // where it will stop, not where it is
    const Assignment a = roles.update(rolling, {}, c);
    EXPECT_EQ(a.role, Role::K3);
    EXPECT_EQ(a.k1, 2);
}

TEST(Roles, PresentK1HasAHeadStart) {
    RoleKeeper roles;
    KeeperConfig c;
    c.role_hysteresis = 0.4;
    ASSERT_EQ(roles.update(keeper_at({1.0, 0.0}, {2.0, 0.0}), {}, c).role, Role::K1);
    EXPECT_EQ(roles.update(keeper_at({1.3, 0.0}, {1.0, 0.0}), {}, c).role, Role::K1);
    EXPECT_EQ(roles.update(keeper_at({1.5, 0.0}, {1.0, 0.0}), {}, c).role, Role::K3);
    EXPECT_EQ(roles.update(keeper_at({0.8, 0.0}, {1.0, 0.0}), {}, c).role, Role::K3);
    EXPECT_EQ(roles.update(keeper_at({0.5, 0.0}, {1.0, 0.0}), {}, c).role, Role::K1);
}

TEST(Roles, FallenKeeperHasAHandicap) {
    RoleKeeper roles;
    const KeeperConfig c;
    world::Beliefs b = keeper_at({1.0, 0.0}, {2.5, 0.0});
    b.self.upright = false;
    EXPECT_EQ(roles.update(b, {}, c).k1, 2);
}

TEST(Roles, WithinTheTieMarginTheWordCounts) {
    RoleKeeper roles;
    const KeeperConfig c;  // tie_margin 0.5
    const std::vector<talk::Report> claim{says(2, true, {}, 0, 9.9)};
    EXPECT_EQ(roles.update(keeper_at({1.0, 0.0}, {1.3, 0.0}), claim, c).k1, 2);
    RoleKeeper far;
    EXPECT_EQ(far.update(keeper_at({1.0, 0.0}, {1.7, 0.0}), claim, c).k1, 1);
    RoleKeeper late;
    const std::vector<talk::Report> old{says(2, true, {}, 0, 8.0)};
    EXPECT_EQ(late.update(keeper_at({1.0, 0.0}, {1.3, 0.0}), old, c).k1, 1);
}

TEST(Roles, OfTwoWhoClaimTheLowestNumberStays) {
    RoleKeeper first;
    const KeeperConfig c;
    ASSERT_EQ(first.update(keeper_at({1.0, 0.0}, {1.3, 0.0}), {}, c).role, Role::K1);
    const std::vector<talk::Report> rival{says(2, true, {}, 0, 9.95)};
    EXPECT_EQ(first.update(keeper_at({1.0, 0.0}, {0.9, 0.0}), rival, c).role, Role::K1);

    RoleKeeper second;  // the same seen by keeper 2
    world::Beliefs b = scene(2, {{0.9, 0.0}, 0.0}, {0.0, 0.0});
    b.mates = {player(1, true, {1.0, 0.0})};
    ASSERT_EQ(second.update(b, {}, c).role, Role::K1);
    const std::vector<talk::Report> word{says(1, true, {}, 0, 9.95)};
    EXPECT_EQ(second.update(b, word, c).role, Role::K3);
}

TEST(Roles, TwoWhoWaitForEachOtherDoNotWaitForEver) {
    RoleKeeper roles;
    const KeeperConfig c;
    // Keeper 2 looks nearer by a little, but says that it is not K1.
    const std::vector<talk::Report> modest{says(2, false, {}, 0, 9.9)};
    EXPECT_EQ(roles.update(keeper_at({1.2, 0.0}, {1.0, 0.0}), modest, c).role, Role::K1);
    RoleKeeper far;
    EXPECT_EQ(far.update(keeper_at({2.0, 0.0}, {1.0, 0.0}), modest, c).role, Role::K3);
}

TEST(Roles, OthersLearnTheirRoleFromK1) {
    RoleKeeper roles;
    const KeeperConfig c;
    const Vec2 target(3.0, -2.0);
    const world::Beliefs b = keeper_at({4.0, 0.0}, {0.2, 0.0});
    const Assignment second = roles.update(b, std::vector{says(2, true, target, 1, 9.5)}, c);
    EXPECT_EQ(second.role, Role::K2);
    EXPECT_EQ(*second.target, target);
    EXPECT_EQ(roles.update(b, std::vector{says(2, true, target, 3, 9.5)}, c).role, Role::K3);
    EXPECT_EQ(roles.update(b, std::vector{says(2, true, target, 1, 7.0)}, c).role, Role::K3);
    EXPECT_EQ(roles.update(b, {}, c).role, Role::K3);
}

TEST(Roles, K2IsClosestToTheTargetWithHeadStart) {
    const KeeperConfig c;
    std::vector<world::Player> mates{player(2, true, {2.0, 0.0}), player(3, true, {-2.0, 0.0})};
    EXPECT_EQ(choose_k2({1.0, 0.0}, mates, 0, c), 2);
    EXPECT_EQ(choose_k2({-1.0, 0.0}, mates, 2, c), 3);
    EXPECT_EQ(choose_k2({-0.1, 0.0}, mates, 2, c), 2);
    mates[0].fallen = true;
    EXPECT_EQ(choose_k2({0.5, 0.0}, mates, 0, c), 3);
    EXPECT_EQ(choose_k2({0.5, 0.0}, {}, 0, c), 0);
}

}  // namespace
}  // namespace k3d::agent::decision
