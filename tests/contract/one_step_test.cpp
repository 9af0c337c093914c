// SPDX-License-Identifier: BSD-3-Clause
// Single steps of the two steppers from the same state: the exact one leads, the fast one is set to
// its state before each step. What they disagree on shows at once, before chaos hides it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "agent/motion/body_motion.h"
#include "contract/body_rig.h"
#include "server/body/scene.h"

namespace k3d::contract {
namespace {

using agent::motion::BodyMotion;
using agent::motion::Config;
using agent::motion::Kick;
using agent::motion::Request;
using agent::motion::Walk;
using server::body::Scene;
using server::physics::BodyState;
using server::physics::Stepper;

/// Largest difference of any body's velocity (m/s) or angular velocity (rad/s), step by step.
class Differences {
  public:
    void add(const server::physics::World& exact, const server::physics::World& fast) {
        const std::vector<BodyState> a = exact.state();
        const std::vector<BodyState> b = fast.state();
        double largest = 0.0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            for (std::size_t k = 7; k < a[i].size(); ++k) {
                largest = std::max(largest, std::abs(a[i][k] - b[i][k]));
            }
        }
        values_.push_back(largest);
    }
    double quantile(double share) {
        std::sort(values_.begin(), values_.end());
        return values_[static_cast<std::size_t>(share * static_cast<double>(values_.size() - 1))];
    }

  private:
    std::vector<double> values_;
};

// ODE's sleeping alone makes a difference of 1e-4: a ball at rest does not settle any further.
constexpr double kMedian = 2e-4;
constexpr double kMost = 5e-3;   // of 95 % of the steps
constexpr double kWorst = 2e-2;  // m/s or rad/s, where limbs move with up to 40 rad/s

void expect_agreement(Differences& differences) {
    EXPECT_LT(differences.quantile(0.5), kMedian);
    EXPECT_LT(differences.quantile(0.95), kMost);
    EXPECT_LT(differences.quantile(1.0), kWorst);
}

/// A robot that follows `request`; `meddle` may change the state before, and the rates of, a step.
void compare_motion(int type, int steps, const std::function<Request(int)>& request,
                    const std::function<void(int, BodyRig&, nao::JointArray&)>& meddle) {
    BodyRig exact(type, {}, Stepper::Exact);
    BodyRig fast(type, {}, Stepper::Fast);
    BodyMotion motion(exact.model(), Config{});
    nao::JointArray rates{};
    Differences differences;
    for (int i = 0; i < steps; ++i) {
        motion.step(exact.sense(), request(i), rates);
        meddle(i, exact, rates);
        fast.world().set_state(exact.world().state());
        exact.advance(rates);
        fast.advance(rates);
        differences.add(exact.world(), fast.world());
    }
    expect_agreement(differences);
}

void leave_alone(int, BodyRig&, nao::JointArray&) {}

class EveryTypeStep : public testing::TestWithParam<int> {};

TEST_P(EveryTypeStep, AgreesInAWalk) {
    const auto walk = [](int i) {
        return Request{.body = Walk{i < 200 ? 1.0 : -0.4, i < 100 ? 0.0 : 0.2, 0.5}, .head = {}};
    };
    compare_motion(GetParam(), 300, walk, leave_alone);
}

TEST_P(EveryTypeStep, AgreesInAFallAndOnTheGround) {
    const auto tip = [](int i, BodyRig&, nao::JointArray& rates) {
        if (i < 50 || i >= 70) return;
        rates[nao::index(nao::JointId::RAnklePitch)] = 2.5;
        rates[nao::index(nao::JointId::LAnklePitch)] = 2.5;
    };
    compare_motion(GetParam(), 350, [](int) { return Request{}; }, tip);
}

INSTANTIATE_TEST_SUITE_P(Types, EveryTypeStep, testing::Range(0, nao::kTypeCount));

TEST(OneStep, AgreesInAKickOfTheBall) {
    const Config config;
    Kick kick;
    kick.ball = {config.kick.straight.ball_forward, -config.kick.straight.ball_outward};
    const auto request = [&kick](int i) {
        Request r;
        if (i > 60) r.body = kick;
        return r;
    };
    double fastest = 0.0;
    const auto place_ball = [&](int i, BodyRig& rig, nao::JointArray&) {
        fastest = std::max(fastest, rig.ball().velocity().norm());
        if (i != 60) return;
        const Vec2 ball = rig.pose().to_global(kick.ball);
        rig.ball().move({ball.x(), ball.y(), 0.0403});
    };
    compare_motion(0, 250, request, place_ball);
    EXPECT_GT(fastest, 2.0) << "the ball must be hit";
}

/// Two robots and the ball, each stepped by either stepper.
struct Crowd {
    explicit Crowd(Stepper stepper) : scene(stepper) {
        scene.add_player(0, {-0.12, 0, 0.4});
        scene.add_player(4, {0.12, 0.1, 0.4});
        scene.ball.move({0.0, 0.3, 0.5});
    }
    void step(int cycle) {
        for (std::size_t p = 0; p < scene.players.size(); ++p) {
            server::body::Robot& robot = *scene.players[p]->robot;
            for (const nao::JointDef& joint : robot.model().joints) {
                const int phase = cycle + 7 * static_cast<int>(nao::index(joint.id));
                const double rate = (phase / 20) % 2 == 0 ? 1.5 : -1.5;
                robot.drive(joint.id, p == 0 ? rate : -rate);
            }
        }
        scene.world.step();
    }
    bool robots_touch() const {
        for (const server::physics::Contact& c : scene.world.contacts()) {
            if (c.b->kind == server::physics::Kind::Robot) return true;
        }
        return false;
    }
    Scene scene;
};

TEST(OneStep, AgreesWhereRobotsFallOverOneAnother) {
    Crowd exact(Stepper::Exact);
    Crowd fast(Stepper::Fast);
    Differences differences;
    int touching = 0;
    for (int cycle = 0; cycle < 300; ++cycle) {
        fast.scene.world.set_state(exact.scene.world.state());
        exact.step(cycle);
        fast.step(cycle);
        touching += exact.robots_touch();
        differences.add(exact.scene.world, fast.scene.world);
    }
    EXPECT_GT(touching, 50);
    expect_agreement(differences);
}

TEST(OneStep, AgreesAtGoalAndWalls) {
    Scene exact(Stepper::Exact);
    Scene fast(Stepper::Fast);
    for (Scene* scene : {&exact, &fast}) {
        // A robot drops onto the goal's roof; the ball flies at its back panel, then at a side wall.
        scene->add_player(0, {15.3, 0.0, 1.3});
        scene->ball.move({14.8, 0.3, 0.3});
        scene->ball.set_velocity({6, 0, 1});
    }
    Differences differences;
    double roof = 0.0;
    for (int cycle = 0; cycle < 150; ++cycle) {
        if (cycle == 80) {
            exact.ball.move({0, 24.0, 0.2});
            exact.ball.set_velocity({0, 8, 0});
        }
        fast.world.set_state(exact.world.state());
        exact.world.step();
        fast.world.step();
        differences.add(exact.world, fast.world);
        if (cycle == 40) roof = exact.players[0]->robot->torso_position().z();
    }
    EXPECT_GT(roof, 1.0) << "the roof must have held it";
    EXPECT_LT(exact.ball.velocity().y(), 0.0) << "the wall must have sent the ball back";
    expect_agreement(differences);
}

}  // namespace
}  // namespace k3d::contract
