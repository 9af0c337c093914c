// SPDX-License-Identifier: BSD-3-Clause
// The physics gives the same bits in every build and on every run.
//
// Built in release and in debug. libm picks its code by CPU features; with and without FMA it gave
// the same bits here, so one hash is expected, and a failure names the features it ran with.
#include <gtest/gtest.h>

#include <string>

#include "server/body/scene.h"

namespace k3d::server {
namespace {

std::string cpu_features() {
    const auto has = [](bool supported, const char* name) {
        return std::string(supported ? " " : " no-") + name;
    };
    return "CPU features:" + has(__builtin_cpu_supports("fma"), "fma") +
           has(__builtin_cpu_supports("avx2"), "avx2") +
           has(__builtin_cpu_supports("avx512f"), "avx512f");
}

/// Two robots swing all joints and fall over one another and the ball: joints, stops, contacts of
/// every kind, 10 s.
std::uint64_t scenario(physics::Stepper stepper) {
    body::Scene scene(stepper);
    body::Player& one = scene.add_player(0, {-0.3, 0, 0.4});
    body::Player& two = scene.add_player(4, {0.3, 0.1, 0.4});
    scene.ball.move({0.0, 0.3, 0.5});
    std::uint64_t hash = 0;
    for (int cycle = 0; cycle < 500; ++cycle) {
        for (const nao::JointDef& joint : two.robot->model().joints) {
            const int phase = cycle + 7 * static_cast<int>(nao::index(joint.id));
            const double rate = (phase / 20) % 2 == 0 ? 1.5 : -1.5;  // no libm in the commands
            one.robot->drive(joint.id, rate);
            two.robot->drive(joint.id, -rate);
        }
        scene.world.step();
        hash = scene.world.hash(hash);
    }
    return hash;
}

struct Golden {
    physics::Stepper stepper;
    std::uint64_t hash;
};

class SameBits : public testing::TestWithParam<Golden> {};

TEST_P(SameBits, InEveryBuild) {
    EXPECT_EQ(scenario(GetParam().stepper), GetParam().hash) << cpu_features();
}

TEST_P(SameBits, InASecondRunOfTheSameProcess) {
    EXPECT_EQ(scenario(GetParam().stepper), scenario(GetParam().stepper));
}

INSTANTIATE_TEST_SUITE_P(
    Steppers, SameBits,
    testing::Values(Golden{physics::Stepper::Exact, 7825709875408925398ULL},
                    Golden{physics::Stepper::Fast, 12109177458656464153ULL}),
    [](const auto& golden) {
        return golden.param.stepper == physics::Stepper::Exact ? "Exact" : "Fast";
    });

}  // namespace
}  // namespace k3d::server
