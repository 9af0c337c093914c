// SPDX-License-Identifier: BSD-3-Clause
#include "agent/motion/walk/steps.h"

#include <gtest/gtest.h>

namespace k3d::agent::motion::walk {
namespace {

constexpr double kHalfWidth = 0.055;

/// Steps of a torso that truly moves as told; `torso` is its pose on the ground.
struct Walked {
    explicit Walked(const Config& config) : steps(config, kHalfWidth, 1.0) {}

    void advance(const Walk& velocity) {
        torso = torso.then({{velocity.forward * 0.02, velocity.left * 0.02}, velocity.turn * 0.02});
        steps.advance(velocity, {});
    }
    Vec2 on_ground(Side side) const { return torso.to_global(steps.foot(side).ground.position); }

    Steps steps;
    Pose2 torso;
};

TEST(Steps, AFootOnTheGroundStaysThere) {
    const Config config;
    Walked walked(config);
    const Walk velocity{0.5, 0.1, 0.8};
    int checked = 0;
    for (int i = 0; i < 200; ++i) {
        const std::array<Vec2, 2> before{walked.on_ground(Side::Right),
                                         walked.on_ground(Side::Left)};
        const std::array<double, 2> air{walked.steps.foot(Side::Right).air,
                                        walked.steps.foot(Side::Left).air};
        walked.advance(velocity);
        for (const Side side : {Side::Right, Side::Left}) {
            const auto k = static_cast<std::size_t>(side);
            if (air[k] > 0.0 || walked.steps.foot(side).air > 0.0) continue;
            ++checked;
            EXPECT_LT((walked.on_ground(side) - before[k]).norm(), 1e-9);
        }
    }
    EXPECT_GT(checked, 100);
}

TEST(Steps, OneFootAtATimeIsInTheAirAndBothTakeTurns) {
    const Config config;
    Walked walked(config);
    int right = 0;
    int left = 0;
    for (int i = 0; i < 400; ++i) {
        walked.advance({0.3, 0.0, 0.0});
        const bool r = walked.steps.foot(Side::Right).lift > 0.0;
        const bool l = walked.steps.foot(Side::Left).lift > 0.0;
        EXPECT_FALSE(r && l);
        right += r;
        left += l;
    }
    EXPECT_GT(right, 100);
    EXPECT_NEAR(right, left, 10);
}

TEST(Steps, FeetNeverCross) {
    const Config config;
    Walked walked(config);
    for (int i = 0; i < 600; ++i) {
        walked.advance({0.0, i < 300 ? 0.35 : -0.35, i < 150 ? 2.0 : -2.0});
        EXPECT_GT(walked.steps.foot(Side::Left).ground.position.y(), 0.02);
        EXPECT_LT(walked.steps.foot(Side::Right).ground.position.y(), -0.02);
        // The hips turn the legs outwards only (reference 5.2: yaw-pitch up to 1 degree).
        EXPECT_GT(walked.steps.foot(Side::Left).ground.yaw, -0.15);
        EXPECT_LT(walked.steps.foot(Side::Right).ground.yaw, 0.15);
    }
}

TEST(Steps, SteppingOnTheSpotReturnsToTheStance) {
    const Config config;
    Walked walked(config);
    for (int i = 0; i < 100; ++i) walked.advance({0.4, 0.1, 0.5});
    for (int i = 0; i < 100; ++i) walked.advance({});
    while (!walked.steps.stepped()) walked.advance({});
    EXPECT_LT(walked.steps.distance_from_stance(), 0.012);
}

}  // namespace
}  // namespace k3d::agent::motion::walk
