// SPDX-License-Identifier: BSD-3-Clause
#include "agent/localisation/refine.h"

#include <gtest/gtest.h>

#include "agent/localisation/sensed_poses.h"
#include "tests/agent/support/synthetic.h"

namespace k3d::agent::localisation {
namespace {

perception::View view_from(const Pose2& pose, std::uint64_t seed) {
    synthetic::Scene scene;
    scene.robot = pose;
    perception::View view;
    perception::look(synthetic::Eyes(seed, true).look(scene),
                     synthetic::body_of(scene, Quat::Identity()), {"Own", 1}, view);
    return view;
}

Pose2 random_pose(RandomStream& random) {
    return {{random.uniform(-6.0, 6.0), random.uniform(-6.0, 6.0)}, random.uniform(-kPi, kPi)};
}

Estimate near(const Pose2& pose, const Vec2& off, double turn) {
    return {{pose.position + off, pose.yaw + turn}, Vec3(1.0, 1.0, 0.1).asDiagonal()};
}

TEST(Refine, OneViewGivesCentimetresFromARoughGuess) {
    RandomStream random(1, "test", "refine");
    const Landmarks landmarks = team_landmarks(wire::Side::Left);
    std::vector<double> errors;
    std::vector<double> claims;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Pose2 truth = random_pose(random);
        const perception::View view = view_from(truth, seed);
        const Fit fit = refine(view, landmarks, near(truth, {0.3, -0.2}, 0.05));
        if (view.landmarks.size() < 2) continue;
        EXPECT_GT(fit.share, 0.9) << "seed " << seed;
        errors.push_back((fit.estimate.pose.position - truth.position).norm());
        claims.push_back(std::sqrt(fit.estimate.covariance(0, 0) + fit.estimate.covariance(1, 1)));
    }
    ASSERT_GT(errors.size(), 100u);
    EXPECT_LT(synthetic::median(errors), 0.03);
    // The claimed spread is of the size of the error, neither boast nor excuse.
    EXPECT_LT(synthetic::median(errors), 3.0 * synthetic::median(claims));
    EXPECT_GT(synthetic::median(errors), 0.2 * synthetic::median(claims));
}

TEST(Refine, AWrongPoseDoesNotExplainTheView) {
    const Pose2 truth{{2.0, -1.0}, 0.2};
    const perception::View view = view_from(truth, 1);
    const Fit fit = refine(view, team_landmarks(wire::Side::Right),
                           {truth, Vec3(1e-4, 1e-4, 1e-4).asDiagonal()});
    EXPECT_LT(fit.share, 0.7);
}

TEST(Refine, AnEmptyViewLeavesThePrior) {
    const Estimate prior = near({{1.0, 2.0}, 0.5}, {0.0, 0.0}, 0.0);
    const Fit fit = refine(perception::View{}, team_landmarks(wire::Side::Left), prior);
    EXPECT_TRUE(fit.estimate.pose.position.isApprox(prior.pose.position, 1e-12));
    EXPECT_TRUE(fit.estimate.covariance.isApprox(prior.covariance, 1e-9));
    EXPECT_EQ(fit.sightings, 0);
    EXPECT_EQ(fit.share, 0.0);
}

TEST(SensedPoses, TheTruthIsAmongThem) {
    RandomStream random(2, "test", "sensed");
    const Landmarks landmarks = team_landmarks(wire::Side::Left);
    int with_one = 0;
    int with_more = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const Pose2 truth = random_pose(random);
        const perception::View view = view_from(truth, seed);
        if (view.landmarks.empty()) continue;
        (view.landmarks.size() == 1 ? with_one : with_more) += 1;
        const SensedPoses sensed = sensed_poses(view, landmarks);
        ASSERT_GE(sensed.count, 1) << "seed " << seed;
        double nearest = 1e9;
        for (int k = 0; k < sensed.count; ++k) {
            const Pose2& pose = sensed.pose[static_cast<std::size_t>(k)];
            nearest = std::min(nearest, (pose.position - truth.position).norm());
        }
        EXPECT_LT(nearest, 1.5) << "seed " << seed;
    }
    EXPECT_GT(with_one, 10);
    EXPECT_GT(with_more, 10);
}

TEST(SensedPoses, LinesAloneSayNothing) {
    perception::View view = view_from({{0.0, 0.0}, 0.0}, 1);
    view.landmarks.clear();
    EXPECT_EQ(sensed_poses(view, team_landmarks(wire::Side::Left)).count, 0);
}

}  // namespace
}  // namespace k3d::agent::localisation
