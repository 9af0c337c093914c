// SPDX-License-Identifier: BSD-3-Clause
// A rolling ball: getting hold of it, and foreseeing where it will stop.
#include <algorithm>
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
constexpr double kKickedSpeed = 1.5;    // m/s: faster than feet push it by accident
constexpr double kTouch = 0.2;          // m/s gained within a frame: a rolling ball gains none
constexpr double kKickRoom = 1.8;       // m ahead of the robot that watches
constexpr double kKickerBehind = 0.5;   // m
constexpr double kKickLeast = 3.0;      // m asked of the kicker
constexpr double kKickMost = 7.0;

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

namespace {

/// A roll to foresee: the ball lies, then the trainer sets it rolling, or a second robot kicks it.
struct Roll {
    Pose2 robot{{-9.0, 0.0}, 0.0};
    Vec2 ball;
    double heading = 0.0;
    double speed = 0.0;           ///< m/s, of a ball set rolling
    std::optional<Pose2> kicker;  ///< before its approach
};

/// The first moment in which the ball moves this fast, or the last one.
std::size_t first_faster(const std::vector<Moment>& moments, double speed) {
    std::size_t i = 0;
    while (i + 1 < moments.size() && moments[i].ball_velocity.norm() < speed) ++i;
    return i;
}

/// The moment from which on the ball rolls untouched: a foot may push it before it is kicked, or
/// meet it again.
std::size_t last_touch(const std::vector<Moment>& moments, std::size_t begun) {
    std::size_t touch = begun;
    for (std::size_t i = begun + 1; i < moments.size(); ++i) {
        const double gained = moments[i].ball_velocity.norm() - moments[i - 1].ball_velocity.norm();
        if (gained > kTouch) touch = i;
    }
    return touch;
}

void act_roll(Stage& stage, const Roll& roll, double kick_limit) {
    stage.begin(roll.robot, ball_at(roll.ball), roll.kicker);
    Vec3 before = stage.truth().ball;
    if (roll.kicker) {
        stage.until(kick_limit, [&](const Truth& t) {
            const double gone = (t.ball - before).head<2>().norm();
            before = t.ball;
            return gone > kKickedSpeed * kFrameSeconds;
        });
    } else {
        // It is seen to lie before it rolls, as before a kick.
        stage.until(0.6, [](const Truth&) { return false; });
        stage.command(ball_at(roll.ball, direction(roll.heading) * roll.speed));
    }
    int still = -10;
    before = stage.truth().ball;
    stage.until(kRollLimit, [&](const Truth& t) {
        still = (t.ball - before).head<2>().norm() < 1e-3 ? still + 1 : std::min(still, 0);
        before = t.ball;
        return still > 3;
    });
}

Measured measure_roll(const std::vector<Moment>& moments, const Roll& roll) {
    Measured out;
    const std::size_t begun =
        last_touch(moments, first_faster(moments, roll.kicker ? kKickedSpeed : 0.5 * roll.speed));
    const bool rolls = begun + 1 < moments.size();
    out.reason = rolls ? "done" : "no_kick";
    if (!rolls) return out;
    const std::size_t from = begun > 0 ? begun - 1 : 0;
    const Vec2 start = moments[from].truth.ball.head<2>();
    out.metrics["rolled_m"] = (moments.back().truth.ball.head<2>() - start).norm();
    out.metrics["ball_speed_mps"] = roll.kicker ? moments[begun + 1].ball_velocity.norm() : roll.speed;
    add_finish_errors(moments, from, "finish", out);
    if (!roll.kicker) return out;
    add_finish_errors(moments, from, "kicked", out);
    double top = 0.0;
    for (const Moment& m : moments) top = std::max(top, m.truth.ball.z());
    out.metrics["kicked_height_m"] = top;
    return out;
}

}  // namespace

Plan plan_ball_rolls(const spec::DrillSpec& spec, int index, RandomStream& random) {
    const spec::DrillSetup s = spec.setup;
    Roll roll;
    roll.ball = roll.robot.position + direction(random.uniform(-0.6, 0.6)) * random.uniform(0.5, 4.0);
    roll.speed = random.uniform(s.roll_least, s.roll_most);
    roll.heading = random.uniform(-kPi, kPi);
    const bool odd = (spec.seed + static_cast<std::uint64_t>(index)) % 2 == 1;
    Plan plan;
    plan.agent_settings = {"drill.task=stand"};
    if (odd && s.roll_kicked) {
        // Not so near that the kicker walks into the robot that watches.
        roll.ball.x() = std::max(roll.ball.x(), roll.robot.position.x() + kKickRoom);
        const Vec2 along = direction(roll.heading);
        roll.kicker = Pose2{roll.ball - kKickerBehind * along, roll.heading};
        const Vec2 target = roll.ball + along * random.uniform(kKickLeast, kKickMost);
        plan.second_settings = {"drill.task=kick", fmt::format("drill.target_x={}", target.x()),
                                fmt::format("drill.target_y={}", target.y())};
    }
    plan.act = [=](Stage& stage) { act_roll(stage, roll, s.kick_limit_s); };
    plan.measure = [=](const std::vector<Moment>& moments) { return measure_roll(moments, roll); };
    return plan;
}

}  // namespace k3d::optimizer::drill
