// SPDX-License-Identifier: BSD-3-Clause
// A rolling ball: getting hold of it, and foreseeing where it will stop.
#include <cmath>
#include <fmt/format.h>

#include "common/field/field.h"
#include "optimizer/drill/plan.h"

namespace k3d::optimizer::drill {

namespace {

constexpr double kHeldDistance = 0.45;  // m from the robot
constexpr double kHeldSpeed = 0.3;      // m/s
constexpr double kHeldFor = 0.3;        // s
constexpr double kRollLimit = 14.0;     // s

}  // namespace

Plan plan_intercept(const spec::DrillSpec& spec, int, RandomStream& random) {
    const spec::DrillSetup s = spec.setup;
    const Pose2 robot{{-7.0, 0.0}, random.uniform(-1.0, 1.0)};
    const Vec2 ball = robot.position + direction(random.uniform(-0.8, 0.8)) * random.uniform(3.0, 5.0);
    // Towards a point beside the robot, so that most balls pass by.
    const Vec2 aim = robot.position + Vec2(random.uniform(-1.0, 1.0), random.uniform(-1.5, 1.5));
    const double speed = random.uniform(s.roll_least, s.roll_most);
    const Vec2 velocity = (aim - ball).normalized() * speed;
    Plan plan;
    plan.agent_settings = {"drill.task=possess", "drill.target_x=0", "drill.target_y=0"};
    const auto held = [](const Truth& t, const Vec2& ball_velocity) {
        return (t.ball.head<2>() - t.robot->pose.position).norm() < kHeldDistance &&
               ball_velocity.norm() < kHeldSpeed && !is_down(t);
    };
    plan.act = [=](Stage& stage) {
        stage.begin(robot, ball_at(ball, velocity));
        Vec3 before = stage.truth().ball;
        double held_for = 0.0;
        stage.until(s.kick_limit_s, [&](const Truth& t) {
            const Vec2 v = (t.ball - before).head<2>() / kFrameSeconds;
            before = t.ball;
            held_for = held(t, v) ? held_for + kFrameSeconds : 0.0;
            return held_for >= kHeldFor;
        });
    };
    plan.measure = [=](const std::vector<Moment>& moments) {
        Measured out;
        const Moment& last = moments.back();
        const bool done = held(last.truth, last.ball_velocity) && last.time < s.kick_limit_s - 0.1;
        out.reason = done ? "done" : count_falls(moments) > 0 ? "fell" : "time_limit";
        out.metrics["held"] = done ? 1.0 : 0.0;
        if (done) out.metrics["time_to_hold_s"] = last.time - kHeldFor;
        out.metrics["falls"] = count_falls(moments);
        out.metrics["ball_speed_mps"] = speed;
        return out;
    };
    return plan;
}

Plan plan_ball_rolls(const spec::DrillSpec& spec, int, RandomStream& random) {
    const spec::DrillSetup s = spec.setup;
    const Pose2 robot{{-9.0, 0.0}, 0.0};
    const Vec2 ball = robot.position + direction(random.uniform(-0.6, 0.6)) * random.uniform(0.5, 4.0);
    const double speed = random.uniform(s.roll_least, s.roll_most);
    const Vec2 velocity = direction(random.uniform(-kPi, kPi)) * speed;
    Plan plan;
    plan.agent_settings = {"drill.task=stand"};
    plan.act = [=](Stage& stage) {
        stage.begin(robot, ball_at(ball));
        // It is seen to lie before it rolls, as before a kick.
        stage.until(0.6, [](const Truth&) { return false; });
        stage.command(ball_at(ball, velocity));
        int still = -10;
        Vec3 before = stage.truth().ball;
        stage.until(kRollLimit, [&](const Truth& t) {
            still = (t.ball - before).head<2>().norm() < 1e-3 ? still + 1 : std::min(still, 0);
            before = t.ball;
            return still > 3;
        });
    };
    plan.measure = [=](const std::vector<Moment>& moments) {
        Measured out;
        out.reason = "done";
        out.metrics["ball_speed_mps"] = speed;
        out.metrics["rolled_m"] = (moments.back().truth.ball.head<2>() - ball).norm();
        for (std::size_t i = 1; i < moments.size(); ++i) {
            if (moments[i].ball_velocity.norm() < 0.5 * speed) continue;
            add_finish_errors(moments, i - 1, out);
            break;
        }
        return out;
    };
    return plan;
}

}  // namespace k3d::optimizer::drill
