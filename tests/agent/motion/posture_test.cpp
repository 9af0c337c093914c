// SPDX-License-Identifier: BSD-3-Clause
#include "agent/motion/posture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace k3d::agent::motion {
namespace {

/// A body turned by hand: what it would sense.
struct Body {
    Quat orientation = Quat::Identity();  // torso -> level world
    double time = 0.0;

    BodySense turn(const Vec3& rate) {
        const double angle = rate.norm() * 0.02;
        if (angle > 0.0) {
            orientation = orientation * Quat(Eigen::AngleAxisd(angle, rate.normalized()));
        }
        time += 0.02;
        BodySense sense;
        sense.time = time;
        sense.gyro = rate;
        sense.acceleration = orientation.conjugate() * Vec3(0, 0, 9.81);
        return sense;
    }
    Vec3 up() const { return orientation.conjugate() * Vec3::UnitZ(); }
};

TEST(PostureFilter, SignsAreThoseOfTheHeader) {
    Body body;
    PostureFilter filter;
    filter.update(body.turn(Vec3::Zero()));
    for (int i = 0; i < 10; ++i) filter.update(body.turn({0, 1.0, 0}));
    EXPECT_NEAR(filter.posture().pitch, 0.2, 1e-3);  // leans forward
    EXPECT_NEAR(filter.posture().roll, 0.0, 1e-3);
    for (int i = 0; i < 10; ++i) filter.update(body.turn({0, -1.0, 0}));
    for (int i = 0; i < 10; ++i) filter.update(body.turn({1.0, 0, 0}));
    EXPECT_NEAR(filter.posture().roll, 0.2, 1e-3);  // leans right
    EXPECT_NEAR(filter.posture().pitch, 0.0, 1e-3);
}

TEST(PostureFilter, FollowsATumbleWithoutBelievableAcceleration) {
    Body body;
    PostureFilter filter;
    filter.update(body.turn(Vec3::Zero()));
    for (int i = 0; i < 200; ++i) {
        BodySense sense = body.turn({2.0 * std::sin(0.1 * i), 3.0 * std::cos(0.07 * i), 1.0});
        sense.acceleration *= 4.0;  // blows
        filter.update(sense);
    }
    EXPECT_LT((filter.posture().up - body.up()).norm(), 0.01);
}

TEST(PostureFilter, TorsoRotationIsLevelAndKeepsHeading) {
    Body body;
    PostureFilter filter;
    filter.update(body.turn(Vec3::Zero()));
    for (int i = 0; i < 15; ++i) filter.update(body.turn({0.8, 1.5, 0.0}));
    const Quat torso = filter.posture().torso;
    EXPECT_LT((torso * filter.posture().up - Vec3::UnitZ()).norm(), 1e-9);
    const Vec3 forward = torso * Vec3::UnitX();
    EXPECT_NEAR(std::atan2(forward.y(), forward.x()), 0.0, 1e-9);
}

TEST(PostureFilter, HeadingGainIsAboutTheVertical) {
    Body body;
    PostureFilter filter;
    filter.update(body.turn(Vec3::Zero()));
    for (int i = 0; i < 25; ++i) filter.update(body.turn({0, 1.0, 0}));  // 0.5 rad forward
    double turned = 0.0;
    for (int i = 0; i < 50; ++i) {
        filter.update(body.turn(body.up() * 1.0));
        turned += filter.turned();
    }
    EXPECT_NEAR(turned, 1.0, 0.01);
}

TEST(PostureFilter, RestCorrectsAWrongEstimateWithinASecond) {
    Body body;
    PostureFilter filter;
    filter.update(body.turn(Vec3::Zero()));
    // Turned without the gyro's knowledge, as by a trainer's command.
    body.orientation = Quat(Eigen::AngleAxisd(1.2, Vec3::UnitY()));
    for (int i = 0; i < 60; ++i) filter.update(body.turn(Vec3::Zero()));
    EXPECT_LT((filter.posture().up - body.up()).norm(), 0.02);
}

}  // namespace
}  // namespace k3d::agent::motion
