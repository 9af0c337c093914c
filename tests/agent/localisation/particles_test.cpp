// SPDX-License-Identifier: BSD-3-Clause
#include "agent/localisation/particles.h"

#include <gtest/gtest.h>

#include "tests/agent/support/synthetic.h"

namespace k3d::agent::localisation {
namespace {

perception::View view_from(const Pose2& pose, double head_yaw, std::uint64_t seed) {
    synthetic::Scene scene;
    scene.robot = pose;
    scene.head_yaw = head_yaw;
    perception::View view;
    perception::look(synthetic::Eyes(seed, true).look(scene),
                     synthetic::body_of(scene, Quat::Identity()), {"Own", 1}, view);
    return view;
}

TEST(Particles, GatherAboutTheTruthEvenWithoutSensedPoses) {
    LocalisationConfig config;
    config.particles = 3000;
    Particles particles(config, RandomStream(1, "test", "particles"));
    const Landmarks landmarks = team_landmarks(wire::Side::Left);
    const Pose2 truth{{-2.0, 3.0}, 0.5};
    Cluster cluster;
    for (int k = 0; k < 60; ++k) {
        const auto seed = static_cast<std::uint64_t>(k);
        const auto view = view_from(truth, radians(50.0) * std::sin(0.2 * k), seed);
        particles.move({}, 0.02, 0.02);
        cluster = particles.weigh(view, landmarks, SensedPoses{});
    }
    EXPECT_GT(cluster.weight, 0.9);
    EXPECT_LT((cluster.pose.position - truth.position).norm(), 0.3);
    EXPECT_LT(std::abs(wrap_angle(cluster.pose.yaw - truth.yaw)), radians(3.0));
}

TEST(Particles, FollowTheOdometry) {
    Particles particles(LocalisationConfig{}, RandomStream(1, "test", "particles"));
    const Landmarks landmarks = team_landmarks(wire::Side::Left);
    const Pose2 truth{{-2.0, 3.0}, 0.5};
    for (int k = 0; k < 30; ++k) {
        const auto view = view_from(truth, 0.0, static_cast<std::uint64_t>(k));
        particles.weigh(view, landmarks, sensed_poses(view, landmarks));
    }
    const Pose2 step{{1.0, 0.5}, 0.3};
    particles.move(step, 0.0, 0.0);
    const Cluster cluster = particles.weigh(perception::View{}, landmarks, SensedPoses{});
    EXPECT_LT((cluster.pose.position - truth.then(step).position).norm(), 0.4);
}

}  // namespace
}  // namespace k3d::agent::localisation
