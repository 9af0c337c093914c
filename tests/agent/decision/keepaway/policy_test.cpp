// SPDX-License-Identifier: BSD-3-Clause
// Tests of the target choice: Algorithm 2 by hand, the grid, ties and hysteresis, network files.
#include "agent/decision/keepaway/policy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "agent/decision/keepaway/scene.h"

namespace k3d::agent::decision {
namespace {

using test::prefers;

const EvaluationConfig kConfig;

// f1 50, f2 0.5, f3 2, f4 1; takers at rest: value 0.5 * 2 / 50 = 0.02.
constexpr Features kGood{50.0, 0.5, 2.0, 1.0, 90.0, 90.0, 0.0, 0.0};

Features with(std::initializer_list<std::pair<std::size_t, double>> changes) {
    Features f = kGood;
    for (const auto& [i, value] : changes) f[i - 1] = value;
    return f;
}

TEST(Algorithm2, PlainValue) { EXPECT_DOUBLE_EQ(hand_coded_cost(kGood, kConfig), 0.02); }

TEST(Algorithm2, FloorOfF1) {
    EXPECT_DOUBLE_EQ(hand_coded_cost(with({{1, 0.0}}), kConfig), 0.5 * 2.0 / 1.0 + 10.0);
}

TEST(Algorithm2, PenaltiesBeginBeyondTheirBounds) {
    EXPECT_DOUBLE_EQ(hand_coded_cost(with({{4, 6.0}}), kConfig), 0.02);
    EXPECT_DOUBLE_EQ(hand_coded_cost(with({{4, 6.01}}), kConfig), 10.02);
    EXPECT_DOUBLE_EQ(hand_coded_cost(with({{3, 4.0}}), kConfig), 0.5 * 4.0 / 50.0);
    EXPECT_DOUBLE_EQ(hand_coded_cost(with({{3, 5.0}}), kConfig), 0.5 * 5.0 / 50.0 + 10.0);
    EXPECT_DOUBLE_EQ(hand_coded_cost(with({{1, 20.0}}), kConfig), 0.05);
    EXPECT_DOUBLE_EQ(hand_coded_cost(with({{1, 16.0}}), kConfig), 0.0625 + 10.0);
}

TEST(Algorithm2, TakerComingTowards) {
    EXPECT_DOUBLE_EQ(hand_coded_cost(with({{5, 29.0}, {7, 0.51}}), kConfig), 10.02);
    EXPECT_DOUBLE_EQ(hand_coded_cost(with({{6, 29.0}, {8, 0.51}}), kConfig), 10.02);
    EXPECT_DOUBLE_EQ(hand_coded_cost(with({{5, 29.0}, {7, 0.5}}), kConfig), 0.02);
    EXPECT_DOUBLE_EQ(hand_coded_cost(with({{5, 30.0}, {7, 0.51}}), kConfig), 0.02);
    EXPECT_DOUBLE_EQ(hand_coded_cost(with({{5, 29.0}, {8, 0.51}}), kConfig), 0.02);
}

TEST(Algorithm2, TakerGoingAwayHalvesButAPenaltyComesFirst) {
    EXPECT_DOUBLE_EQ(hand_coded_cost(with({{5, 106.0}, {7, 0.51}}), kConfig), 0.01);
    EXPECT_DOUBLE_EQ(hand_coded_cost(with({{6, 106.0}, {8, 0.51}}), kConfig), 0.01);
    EXPECT_DOUBLE_EQ(hand_coded_cost(with({{5, 105.0}, {7, 0.51}}), kConfig), 0.02);
    EXPECT_DOUBLE_EQ(hand_coded_cost(with({{5, 106.0}, {7, 0.51}, {4, 7.0}}), kConfig), 10.02);
    EXPECT_DOUBLE_EQ(hand_coded_cost(with({{5, 106.0}, {7, 0.6}, {6, 10.0}, {8, 0.6}}), kConfig), 10.02);
}

TEST(TargetGrid, ThePapersEightyOnePointsAndOtherAreas) {
    const auto grid = target_grid(10.0, kConfig);
    ASSERT_EQ(grid.size(), 81u);
    EXPECT_EQ(grid.front(), Vec2(-4.0, -4.0));
    EXPECT_EQ(grid.back(), Vec2(4.0, 4.0));
    EXPECT_EQ(target_grid(8.0, kConfig).size(), 49u);    // +-3.2
    EXPECT_EQ(target_grid(14.0, kConfig).size(), 121u);  // +-5.6
    for (const Vec2& p : target_grid(14.0, kConfig)) EXPECT_LE(p.cwiseAbs().maxCoeff(), 5.6);
}

/// What becomes of a network that stands in a file.
Policy load_written(const network::Definition& d) {
    struct File {
        std::string path = testing::TempDir() + "k3d_policy_" + std::to_string(getpid()) + ".json";
        ~File() { std::filesystem::remove(path); }
    } const file;
    std::ofstream(file.path) << network::to_json(d);
    return load_policy(file.path);
}

TEST(Policy, NamesAndNetworkFiles) {
    EXPECT_EQ(load_policy("handcoded").kind, Policy::Kind::Evaluate);
    EXPECT_EQ(load_policy("still").kind, Policy::Kind::Still);
    EXPECT_EQ(load_policy("hold").kind, Policy::Kind::Hold);
    EXPECT_EQ(load_policy("random").kind, Policy::Kind::Random);
    EXPECT_TRUE(load_written(prefers(3, 1.0)).cost.has_value());
    EXPECT_THAT([] { load_policy("handcodet"); },
                testing::ThrowsMessage<network::NetworkError>(
                    "keeper.policy \"handcodet\" is none of handcoded, still, hold, random, and "
                    "there is no such network file"));
    network::Definition wrong = prefers(3, 1.0);
    wrong.inputs[2].name = "f9";
    wrong.links[0].from = "f9";
    EXPECT_THROW(load_written(wrong), network::NetworkError);
    network::Definition swapped = test::prefers_both({"f4", 1.0}, {"f9", 1.0});
    EXPECT_TRUE(load_written(swapped).values_places);
    std::swap(swapped.outputs[0], swapped.outputs[1]);
    EXPECT_THROW(load_written(swapped), network::NetworkError);
}

const Room kAll = [](const Vec2&) { return 1.0; };

PassSituation quiet() {
    PassSituation s;
    s.ball = {-2.0, 0.0};
    s.receivers = {{3.0, 0.0}};
    return s;
}

TEST(BestTarget, NetworkLowestCostWins) {
    // Cost f4: the point nearest to the receiver. Cost -f4: the farthest, first of equals.
    Policy policy;
    policy.cost.emplace(prefers(4, 1.0), "test");
    const auto grid = target_grid(10.0, kConfig);
    EXPECT_EQ(best_target(grid, quiet(), policy, kConfig, kAll, {}, 0.0).point, Vec2(3.0, 0.0));
    policy.cost.emplace(prefers(4, -1.0), "test");
    const Target far = best_target(grid, quiet(), policy, kConfig, kAll, {}, 0.0);
    EXPECT_EQ(far.point, Vec2(-4.0, -4.0));
    EXPECT_DOUBLE_EQ(far.cost, -65.0);
}

TEST(BestTarget, TellsAllPointsWithRoomAndTheirCosts) {
    Policy policy;
    policy.cost.emplace(prefers(4, 1.0), "test");
    const auto grid = target_grid(10.0, kConfig);
    const Room right = [](const Vec2& p) { return p.x(); };
    std::vector<Scored> scored{{Vec2::Zero(), 7.0}};
    const Target best = best_target(grid, quiet(), policy, kConfig, right, {}, 0.0, &scored);
    EXPECT_EQ(scored.size(), 45u);  // of 9 columns, those at 0 and to the right
    for (const Scored& s : scored) {
        EXPECT_GE(s.point.x(), 0.0);
        EXPECT_GE(s.cost, best.cost);
        EXPECT_NEAR(s.cost, (s.point - Vec2(3.0, 0.0)).squaredNorm(), 1e-9);
    }
}

TEST(BestTarget, NeverNextToTheBallNorWhereItIsForbidden) {
    Policy policy;
    policy.cost.emplace(prefers(3, -1.0), "test");  // likes lengths far from ideal: 0 best
    PassSituation s = quiet();
    s.ball = {0.0, 0.0};
    EvaluationConfig c;
    const auto grid = target_grid(10.0, c);
    const Target near = best_target(grid, s, policy, c, kAll, {}, 0.0);
    EXPECT_DOUBLE_EQ((near.point - s.ball).norm(), 1.0);
    const Room right = [](const Vec2& p) { return p.x() - 0.5; };
    EXPECT_EQ(best_target(grid, s, policy, c, right, {}, 0.0).point, Vec2(1.0, 0.0));
    // Room nowhere: where there is most.
    const Room none = [](const Vec2& p) { return -1.0 - (p - Vec2(2.0, 3.0)).norm(); };
    EXPECT_EQ(best_target(grid, s, policy, c, none, {}, 0.0).point, Vec2(2.0, 3.0));
}

TEST(BestTarget, KeepsThePreviousWithinTheMargin) {
    const auto grid = target_grid(10.0, kConfig);
    // Ball (-2, 0): (4, 0) is 6 m off; (4, 1) is 6.083 m off, and of 80 points only that one is better.
    const Vec2 old(4.0, 1.0);
    for (const double scale : {1.0, 100.0}) {
        Policy policy;
        policy.cost.emplace(prefers(3, scale), "test");
        const auto chosen = [&](double keep) {
            return best_target(grid, quiet(), policy, kConfig, kAll, old, keep).point;
        };
        EXPECT_EQ(chosen(0.02), old);
        EXPECT_EQ(chosen(0.01), Vec2(4.0, 0.0));
        EXPECT_EQ(chosen(0.0), Vec2(4.0, 0.0));
    }
}

}  // namespace
}  // namespace k3d::agent::decision
