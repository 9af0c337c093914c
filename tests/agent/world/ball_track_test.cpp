// SPDX-License-Identifier: BSD-3-Clause
#include "agent/world/ball_track.h"

#include <gtest/gtest.h>

#include <functional>

#include "common/field/field.h"
#include "common/random/stream.h"

namespace k3d::agent::world {
namespace {

constexpr double kThreeMetres = 0.01;  // m: error of a ball seen from there

/// Cycles of 20 ms with a sighting in every third.
struct Trial {
    explicit Trial(std::uint64_t seed, double noise = 0.015)
        : random(seed, "test", "ball"), sd(noise) {}

    void cycle(const std::optional<Vec2>& truth) {
        now = 0.02 * ++count;
        track.predict(now);
        if (truth && count % 3 == 0) {
            track.see(*truth + sd * Vec2(random.normal(), random.normal()), sd, now);
        }
        track.report(now, ball);
    }
    void run(double seconds, const std::function<Vec2(double)>& truth) {
        const double start = now;
        for (int k = 0; k < static_cast<int>(seconds * 50.0 + 0.5); ++k) {
            cycle(truth(0.02 * (count + 1) - start));
        }
    }

    RandomStream random;
    double sd;
    BallTrack track{BallConfig{}};
    Ball ball;
    int count = 0;
    double now = 0.0;
};

std::function<Vec2(double)> roll(const Vec2& start, const Vec2& velocity) {
    return [=](double t) -> Vec2 {
        return start + velocity * (1.0 - std::exp(-field::kRollDecay * t)) / field::kRollDecay;
    };
}

TEST(BallTrack, ABallAtRestIsKnownToACentimetreAndNeverMoves) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        Trial trial(seed);
        trial.run(0.5, roll({2.0, 1.0}, {0.0, 0.0}));
        for (int k = 0; k < 500; ++k) {
            trial.cycle(Vec2(2.0, 1.0));
            ASSERT_FALSE(trial.ball.moving) << "seed " << seed << " cycle " << k;
            ASSERT_EQ(trial.ball.velocity, Vec2::Zero());
            ASSERT_EQ(trial.ball.finish, trial.ball.position);
        }
        EXPECT_LT((trial.ball.position - Vec2(2.0, 1.0)).norm(), 0.02);
    }
}

TEST(BallTrack, AKickIsSeenWithinFourSeesAndTheSpeedIsRightWithinTenPercent) {
    for (const double speed : {1.0, 2.5, 5.0}) {
        const Vec2 velocity = speed * direction(0.6);
        std::vector<double> errors;
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            Trial trial(seed, kThreeMetres);
            trial.run(1.0, roll({0.0, 0.0}, {0.0, 0.0}));
            trial.run(0.24, roll({0.0, 0.0}, velocity));
            EXPECT_TRUE(trial.ball.moving) << "speed " << speed << " seed " << seed;
            Trial later(seed, kThreeMetres);
            later.run(1.0, roll({0.0, 0.0}, {0.0, 0.0}));
            later.run(0.6, roll({0.0, 0.0}, velocity));
            const Vec2 truth = velocity * std::exp(-field::kRollDecay * 0.6);
            errors.push_back((later.ball.velocity - truth).norm() / truth.norm());
        }
        std::sort(errors.begin(), errors.end());
        EXPECT_LT(errors[errors.size() / 2], 0.10) << "speed " << speed;
    }
}

TEST(BallTrack, TheStoppingPointConvergesAndStaysWhenTheBallIsLostFromView) {
    Trial trial(3);
    const Vec2 velocity(3.0, -1.0);
    const Vec2 stop = velocity / field::kRollDecay;
    trial.run(1.0, roll({0.0, 0.0}, {0.0, 0.0}));
    trial.run(0.9, roll({0.0, 0.0}, velocity));
    EXPECT_LT((trial.ball.finish - stop).norm(), 0.25);
    for (int k = 0; k < 50; ++k) trial.cycle(std::nullopt);
    EXPECT_LT((trial.ball.finish - stop).norm(), 0.25);
    EXPECT_LT((trial.ball.position - roll({0, 0}, velocity)(1.9)).norm(), 0.25);
    trial.run(5.0, [&](double t) { return roll({0.0, 0.0}, velocity)(1.9 + t); });
    EXPECT_FALSE(trial.ball.moving);
    EXPECT_LT((trial.ball.finish - stop).norm(), 0.05);
}

TEST(BallTrack, TellsWhereTheBallWasHalfASecondAgo) {
    Trial trial(4, 0.003);
    const auto truth = roll({0.0, 0.0}, {2.0, 0.0});
    trial.run(1.2, truth);
    EXPECT_LT((trial.ball.position_before - truth(0.7)).norm(), 0.05);
}

TEST(BallTrack, ATeleportIsNoMotion) {
    Trial trial(5);
    trial.run(1.0, roll({0.0, 0.0}, {0.0, 0.0}));
    for (int k = 0; k < 50; ++k) {
        trial.cycle(Vec2(5.0, 3.0));
        EXPECT_FALSE(trial.ball.moving) << k;
    }
    EXPECT_LT((trial.ball.position - Vec2(5.0, 3.0)).norm(), 0.03);
}

TEST(BallTrack, AStoppedBallStops) {
    Trial trial(6);
    trial.run(0.6, roll({0.0, 0.0}, {3.0, 0.0}));
    const Vec2 held = roll({0.0, 0.0}, {3.0, 0.0})(0.6);  // a foot holds it there
    trial.run(0.5, roll(held, {0.0, 0.0}));
    EXPECT_FALSE(trial.ball.moving);
    EXPECT_LT((trial.ball.finish - held).norm(), 0.05);
}

TEST(BallTrack, ForgetsAfterTheMemoryTimeAndAfterMisses) {
    Trial trial(7);
    trial.run(0.5, roll({0.0, 0.0}, {0.0, 0.0}));
    EXPECT_TRUE(trial.ball.known);
    const BallConfig config;
    for (int k = 0; k < config.misses; ++k) trial.track.miss();
    trial.cycle(std::nullopt);
    EXPECT_FALSE(trial.ball.known);
    trial.run(0.1, roll({0.0, 0.0}, {0.0, 0.0}));
    EXPECT_TRUE(trial.ball.known);
    for (int k = 0; k < static_cast<int>(config.memory * 50.0) + 2; ++k) trial.cycle(std::nullopt);
    EXPECT_FALSE(trial.ball.known);
}

TEST(BallTrack, TakesTheBallFromMatesOnlyWhenItSeesNoneItself) {
    Trial trial(8);
    trial.track.hear({3.0, 0.0}, {1.0, 0.0}, trial.now);
    trial.cycle(std::nullopt);
    EXPECT_TRUE(trial.ball.known);
    EXPECT_LT(trial.ball.seen, -1e8);
    EXPECT_TRUE(trial.ball.moving);
    EXPECT_NEAR(trial.ball.finish.x(), 3.0 + 1.0 / field::kRollDecay, 0.05);
    trial.run(0.5, roll({1.0, 1.0}, {0.0, 0.0}));
    trial.track.hear({-4.0, 0.0}, {0.0, 0.0}, trial.now);
    trial.cycle(Vec2(1.0, 1.0));
    EXPECT_LT((trial.ball.position - Vec2(1.0, 1.0)).norm(), 0.05);
}

}  // namespace
}  // namespace k3d::agent::world
