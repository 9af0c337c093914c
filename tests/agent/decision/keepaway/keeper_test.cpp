// SPDX-License-Identifier: BSD-3-Clause
// Tests of a keeper's conduct: hold or kick, targets, home, boundary, what it says.
#include "agent/decision/keepaway/keeper.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "agent/decision/keepaway/scene.h"
#include "common/clock/clock.h"

namespace k3d::agent::decision {
namespace {

using test::is_kick;
using test::is_stand;
using test::is_walk;
using test::player;
using test::says;
using test::scene;

Keeper keeper(const std::string& policy = "handcoded", KeeperSettings settings = {}) {
    return {settings, load_policy(policy), test::simple_kick(), RandomStream(1, "left.1", "target")};
}

/// Keeper 1 stands behind the ball at (-3, 0), aimed along +x at keeper 2; takers at `distance`.
world::Beliefs at_ball(double distance, double now = 10.0) {
    world::Beliefs b = scene(1, {{-3.2, 0.0}, 0.0}, {-3.0, 0.0}, now);
    b.mates = {player(2, true, {3.0, 0.0}), player(3, true, {0.0, -4.0})};
    b.opponents = {player(1, false, Vec2(-3.0, distance)), player(2, false, {4.0, 4.5})};
    return b;
}

/// Runs some cycles, since Algorithm 1 changes state one call late; the last decision.
Decision settle(Keeper& k, world::Beliefs b, const motion::State& body = {},
                std::vector<talk::Report> reports = {}) {
    Decision d;
    for (int i = 0; i < 5; ++i) {
        b.now += 0.02;
        b.ball.seen = b.now;
        d = k.decide(b, body, reports);
    }
    return d;
}

TEST(Keeper, HoldsWhileTakersAreFarAndKicksWhenOneIsNear) {
    Keeper far = keeper();
    const Decision hold = settle(far, at_ball(3.5));
    EXPECT_EQ(hold.account.role, "K1");
    EXPECT_FALSE(is_kick(hold.request.body));

    Keeper near = keeper();
    Decision d = settle(near, at_ball(1.5));
    // Walk it to where it wants to stand, then it kicks at its target.
    world::Beliefs b = at_ball(1.5);
    ASSERT_TRUE(d.account.target);
    const double yaw = yaw_of(*d.account.target - b.ball.position);
    b.self.pose = {b.ball.position - direction(yaw) * 0.2, yaw};
    d = settle(near, b);
    ASSERT_TRUE(is_kick(d.request.body)) << d.account.skill;
    EXPECT_NEAR(std::get<motion::Kick>(d.request.body).direction, 0.0, 1e-9);
    EXPECT_NEAR(std::get<motion::Kick>(d.request.body).distance,
                std::min((*d.account.target - b.ball.position).norm(), KeeperConfig{}.longest_kick),
                1e-9);
}

TEST(Keeper, HoldPolicyNeverKicksAndStillNeverMoves) {
    Keeper hold = keeper("hold");
    for (int i = 0; i < 50; ++i) EXPECT_FALSE(is_kick(settle(hold, at_ball(0.5)).request.body));
    Keeper still = keeper("still");
    EXPECT_TRUE(is_stand(settle(still, at_ball(0.5)).request.body));
    world::Beliefs away = at_ball(0.5);
    away.self.pose.position = {-1.0, 3.0};
    EXPECT_TRUE(is_stand(settle(still, away).request.body));
}

TEST(Keeper, RandomPolicyKeepsItsTargetUntilTheKickIsDone) {
    Keeper k = keeper("random");
    world::Beliefs b = at_ball(3.5);
    const Vec2 first = *settle(k, b).account.target;
    EXPECT_EQ(*settle(k, b).account.target, first);
    bool changed = false;
    for (int i = 0; i < 10; ++i) {
        motion::State done;
        done.kick_done = true;
        k.decide(b, done, {});
        changed = changed || *settle(k, b).account.target != first;
    }
    EXPECT_TRUE(changed);
}

TEST(Keeper, FinishesASwingOnceBegun) {
    Keeper k = keeper();
    world::Beliefs b = at_ball(1.0);
    const Vec2 target = *settle(k, b).account.target;
    const double yaw = yaw_of(target - b.ball.position);
    b.self.pose = {b.ball.position - direction(yaw) * 0.2, yaw};
    ASSERT_TRUE(is_kick(settle(k, b).request.body));
    motion::State kicking;
    kicking.activity = motion::Activity::Kicking;
    b.ball.position = b.ball.finish = {2.0, 0.0};  // gone: it is not K1 any more
    const Decision d = settle(k, b, kicking);
    EXPECT_TRUE(is_kick(d.request.body));
    EXPECT_EQ(d.account.skill, "kick");
}

TEST(Keeper, K1SaysTargetAndHelper) {
    Keeper k = keeper();
    const Decision d = settle(k, at_ball(2.0));
    ASSERT_TRUE(d.say);
    EXPECT_TRUE(d.say->claims_k1);
    ASSERT_TRUE(d.say->target);
    EXPECT_EQ(*d.say->target, *d.account.target);
    EXPECT_EQ(d.say->k2, d.account.k2);
    EXPECT_NE(d.say->k2, 0);
    EXPECT_NE(d.say->k2, 1);
    ASSERT_TRUE(d.say->ball);
    EXPECT_EQ(*d.say->ball, Vec2(-3.0, 0.0));
    const auto heard = talk::decode(talk::encode(*d.say));
    ASSERT_TRUE(heard);
    EXPECT_TRUE(heard->claims_k1);
}

TEST(Keeper, DoesNotShootIntoATakerThatComes) {
    // Cost f3, which knows no takers: K1 at (-3, 0) wants to pass 6 m. A taker stands on that way.
    world::Beliefs b = at_ball(2.0);
    b.opponents[0].position = b.opponents[0].lagged = b.ball.position + Vec2(1.2, 0.0);
    const auto off_the_taker = [&](const KeeperSettings& settings) {
        Policy length;
        length.cost.emplace(test::prefers(3, 1.0), "test");
        Keeper k(settings, std::move(length), test::simple_kick(), RandomStream(1, "left.1", "target"));
        return std::abs(yaw_of(*settle(k, b).account.target - b.ball.position));
    };
    const KeeperSettings careful;
    KeeperSettings careless;
    careless.keeper.lane_margin = -1.0;
    const double least = std::asin(careful.keeper.lane_margin / 1.2);
    EXPECT_LT(off_the_taker(careless), least);
    EXPECT_GE(off_the_taker(careful), least - 1e-9);
}

TEST(Keeper, TellsOfOpponentsInViewInTurns) {
    Keeper k = keeper();
    world::Beliefs b = at_ball(2.0);
    const double round = 6 * k3d::kCycleSeconds;
    const auto told = [&] {
        b.now += round;
        for (world::Player& p : b.opponents) p.eyes = b.now;
        return k.decide(b, {}, {}).say->opponent->unum;
    };
    const int first = told();
    EXPECT_NE(told(), first);
    EXPECT_EQ(told(), first);
    b.now += 1.0;  // nobody in view any more
    EXPECT_FALSE(k.decide(b, {}, {}).say->opponent);
}

/// Keeper 3 at home (0, -4), keeper 1 has the ball.
world::Beliefs away(Pose2 self) {
    world::Beliefs b = scene(3, self, {-3.0, 0.0});
    b.mates = {player(1, true, {-3.2, 0.0}), player(2, true, {3.0, 3.0})};
    return b;
}

TEST(Keeper, K2GoesToTheTargetAndThenFacesTheBall) {
    Keeper k = keeper();
    const std::vector<talk::Report> order{says(1, true, Vec2(2.0, -3.0), 3, 10.0)};
    Decision d = settle(k, away({{0.0, -4.0}, 0.0}), {}, order);
    EXPECT_EQ(d.account.role, "K2");
    EXPECT_EQ(*d.account.target, Vec2(2.0, -3.0));
    ASSERT_TRUE(is_walk(d.request.body));
    EXPECT_GT(std::get<motion::Walk>(d.request.body).forward, 0.2);

    const Vec2 there(2.0, -3.0);
    d = settle(k, away({there, 0.0}), {}, order);  // there, but looking away from the ball
    ASSERT_TRUE(is_walk(d.request.body));
    EXPECT_GT(std::abs(std::get<motion::Walk>(d.request.body).turn), 0.3);
    d = settle(k, away({there, yaw_of(Vec2(-3.0, 0.0) - there)}), {}, order);
    EXPECT_TRUE(is_stand(d.request.body));
}

TEST(Keeper, K3StaysHomeWhereItWasBorn) {
    Keeper k = keeper();
    const Pose2 born{{1.0, -2.0}, yaw_of(Vec2(-3.0, 0.0) - Vec2(1.0, -2.0))};
    Decision d = settle(k, away(born));
    EXPECT_EQ(d.account.role, "K3");
    EXPECT_TRUE(is_stand(d.request.body));
    d = settle(k, away({{3.0, -2.0}, kPi}));
    EXPECT_EQ(*d.account.target, born.position);
    ASSERT_TRUE(is_walk(d.request.body));
    EXPECT_GT(std::get<motion::Walk>(d.request.body).forward, 0.2);
}

TEST(Keeper, ANewMatchHasANewHome) {
    Keeper k = keeper();
    settle(k, away({{1.0, -2.0}, 0.0}));
    k.forget();
    settle(k, away({{2.0, 1.0}, 0.0}));
    const Decision d = settle(k, away({{3.0, -2.0}, kPi}));
    EXPECT_EQ(*d.account.target, Vec2(2.0, 1.0));
}

TEST(Keeper, K3GoesWhereThePolicysNetworkWantsIt) {
    // K3's place: as near as can be to where the pass goes, (2, -3).
    const std::string file = testing::TempDir() + "/k3d-places-" + std::to_string(getpid()) + ".json";
    std::ofstream(file) << network::to_json(test::prefers_both({"f3", 1.0}, {"f9", 1.0}));
    const std::vector<talk::Report> order{says(1, true, Vec2(2.0, -3.0), 2, 10.0)};
    Keeper k = keeper(file);
    const Decision d = settle(k, away({{1.0, -2.0}, 0.0}), {}, order);
    EXPECT_EQ(d.account.skill, "get_open");
    EXPECT_EQ(*d.account.target, Vec2(2.0, -3.0));
    std::filesystem::remove(file);
}

TEST(Keeper, WalksOnlyInsideTheArea) {
    Keeper k = keeper();
    // The order points at the corner beyond the boundary; stop at 5 - 0.4 m.
    const std::vector<talk::Report> order{says(1, true, Vec2(7.0, -7.0), 3, 10.0)};
    const Vec2 edge(4.6, -4.6);
    const Decision d =
        settle(k, away({edge, yaw_of(Vec2(-3.0, 0.0) - edge)}), {}, order);
    EXPECT_TRUE(is_stand(d.request.body));
}

TEST(Keeper, DoesNotAimWhereItWouldStandOutside) {
    // Ball 20 cm inside the left boundary: only along it can be kicked from inside.
    Keeper k = keeper();
    world::Beliefs b = at_ball(3.5);
    b.ball.position = b.ball.finish = {-4.8, 0.0};
    b.self.pose.position = {-4.5, 0.0};
    const Decision d = settle(k, b);
    const double yaw = yaw_of(*d.account.target - b.ball.position);
    const Vec2 stance = b.ball.position - direction(yaw) * 0.2;
    EXPECT_LE(stance.cwiseAbs().maxCoeff(), 5.0 - KeeperConfig{}.stance_margin);
}

TEST(Keeper, BirthPlacesFormThePapersTriangle) {
    const KeepawayConfig c;
    EXPECT_NEAR((birth_place(1, c) - Vec2(0.0, 2.5)).norm(), 0.0, 1e-9);
    const double side = (birth_place(1, c) - birth_place(2, c)).norm();
    EXPECT_NEAR((birth_place(2, c) - birth_place(3, c)).norm(), side, 1e-9);
    EXPECT_NEAR((birth_place(3, c) - birth_place(1, c)).norm(), side, 1e-9);
}

}  // namespace
}  // namespace k3d::agent::decision
