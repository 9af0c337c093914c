// SPDX-License-Identifier: BSD-3-Clause
// The estimated pose against the truth, on synthetic views with the reference's noise.
#include "agent/localisation/localiser.h"

#include <gtest/gtest.h>

#include "tests/agent/support/synthetic.h"

namespace k3d::agent::localisation {
namespace {

/// Runs walker, eyes and localiser side by side.
struct Trial {
    Trial(const Pose2& start, double speed, std::uint64_t seed, wire::Side on = wire::Side::Left)
        : walker(start, speed, seed),
          eyes(seed, true),
          localiser(LocalisationConfig{}, seed),
          side(on) {}

    void cycle(bool upright = true) {
        const Pose2 odometry = walker.step();
        ++count;
        const perception::View* seen = nullptr;
        if (count % 3 == 0) {
            const auto state = synthetic::body_of(walker.scene, walker.known_tilt);
            perception::look(eyes.look(walker.scene), state, {"Own", 1}, view);
            seen = &view;
        }
        location = localiser.update(seen, odometry, upright, side, 0.02);
    }
    void run(double seconds) {
        for (int k = 0; k < static_cast<int>(seconds * 50.0); ++k) cycle();
    }
    Pose2 truth() const {
        return side == wire::Side::Right ? synthetic::turned_half(walker.scene.robot)
                                         : walker.scene.robot;
    }
    double position_error() const { return (location.pose.position - truth().position).norm(); }
    double yaw_error_deg() const {
        return degrees(std::abs(wrap_angle(location.pose.yaw - truth().yaw)));
    }

    synthetic::Walker walker;
    synthetic::Eyes eyes;
    Localiser localiser;
    wire::Side side;
    perception::View view;
    Location location;
    int count = 0;
};

Pose2 random_pose(RandomStream& random, double reach) {
    return {{random.uniform(-reach, reach), random.uniform(-reach, reach)},
            random.uniform(-kPi, kPi)};
}

TEST(Localiser, FindsItselfWithinTwoSecondsFromAnywhereInTheMiddle) {
    RandomStream random(5, "test", "starts");
    std::vector<double> position_errors;
    std::vector<double> yaw_errors;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const auto side = seed % 2 == 0 ? wire::Side::Left : wire::Side::Right;
        Trial run(random_pose(random, 6.0), seed % 4 < 2 ? 0.0 : 0.5, seed, side);
        run.run(2.0);
        EXPECT_TRUE(run.location.localised) << "seed " << seed;
        EXPECT_LT(run.position_error(), 0.3) << "seed " << seed;
        position_errors.push_back(run.position_error());
        yaw_errors.push_back(run.yaw_error_deg());
    }
    RecordProperty("median_position_mm",
                   static_cast<int>(1000 * synthetic::median(position_errors)));
    EXPECT_LT(synthetic::median(position_errors), 0.05);
    EXPECT_LT(synthetic::median(yaw_errors), 1.0);
}

TEST(Localiser, StaysExactOnAWalkOfAMinute) {
    Trial run({{-2.0, 1.0}, 0.5}, 0.5, 3);
    run.run(2.0);
    std::vector<double> position_errors;
    std::vector<double> yaw_errors;
    for (int k = 0; k < 3000; ++k) {
        run.cycle();
        EXPECT_TRUE(run.location.localised) << "cycle " << k;
        position_errors.push_back(run.position_error());
        yaw_errors.push_back(run.yaw_error_deg());
    }
    EXPECT_LT(synthetic::median(position_errors), 0.05);
    EXPECT_LT(synthetic::median(yaw_errors), 1.0);
    EXPECT_LT(*std::max_element(position_errors.begin(), position_errors.end()), 0.15);
}

TEST(Localiser, RecoversWithinThreeSecondsWhenCarriedAway) {
    RandomStream random(6, "test", "places");
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Trial run(random_pose(random, 5.0), 0.4, seed);
        run.run(2.0);
        run.walker.scene.robot = random_pose(random, 5.0);
        run.run(3.0);
        EXPECT_TRUE(run.location.localised) << "seed " << seed;
        EXPECT_LT(run.position_error(), 0.15) << "seed " << seed;
        EXPECT_LT(run.yaw_error_deg(), 2.0) << "seed " << seed;
    }
}

TEST(Localiser, KnowsThatItDoesNotKnowAfterAFallAndFindsItselfAgain) {
    RandomStream random(7, "test", "falls");
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Trial run(random_pose(random, 5.0), 0.4, seed);
        run.run(2.0);
        const Pose2 before = run.walker.scene.robot;
        for (int k = 0; k < 150; ++k) run.cycle(false);
        EXPECT_FALSE(run.location.localised);
        EXPECT_GT(run.location.yaw_sd, 0.5);
        // It rolled over and got up a little aside, turned by up to 150 degrees.
        run.walker.scene.robot = before.then(
            {{random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4)}, random.uniform(-2.6, 2.6)});
        run.run(1.0);
        EXPECT_TRUE(run.location.localised) << "seed " << seed;
        EXPECT_LT(run.position_error(), 0.15) << "seed " << seed;
    }
}

TEST(Localiser, SpreadGrowsWithoutViewsAndTheOdometryIsFollowed) {
    Trial run({{1.0, 2.0}, 0.0}, 0.0, 1);
    run.run(2.0);
    ASSERT_TRUE(run.location.localised);
    ASSERT_LT(run.location.position_sd, 0.05);
    const Pose2 start = run.location.pose;
    Location location;
    const auto walk = [&](bool upright) {
        for (int k = 0; k < 100; ++k) {
            location =
                run.localiser.update(nullptr, {{0.01, 0.0}, 0.0}, upright, wire::Side::Left, 0.02);
        }
    };
    walk(true);
    EXPECT_LT((location.pose.position - start.to_global({1.0, 0.0})).norm(), 1e-9);
    EXPECT_GT(location.position_sd, 0.1);
    const double upright_sd = location.yaw_sd;
    walk(false);
    EXPECT_LT((location.pose.position - start.to_global({1.0, 0.0})).norm(), 1e-9)
        << "no odometry while down";
    EXPECT_GT(location.yaw_sd, 2.0 * upright_sd);
}

TEST(Localiser, TheSameSeedGivesTheSamePoseToTheBit) {
    const auto poses = [](std::uint64_t seed) {
        Trial run({{-1.0, 3.0}, 2.0}, 0.5, seed);
        run.run(5.0);
        return run.location.pose;
    };
    const Pose2 once = poses(11);
    const Pose2 again = poses(11);
    EXPECT_EQ(once.position, again.position);
    EXPECT_EQ(once.yaw, again.yaw);
    EXPECT_NE(once.position, poses(12).position);
}

TEST(Localiser, WithoutASideNothingIsClaimed) {
    Trial run({{0.0, 0.0}, 0.0}, 0.0, 1, wire::Side::None);
    run.run(1.0);
    EXPECT_FALSE(run.location.localised);
}

}  // namespace
}  // namespace k3d::agent::localisation
