// SPDX-License-Identifier: BSD-3-Clause
// Kicks at a target: of a ball that lies, and of one that comes rolling (paper 3.1).
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "optimizer/drill/plan.h"
#include "optimizer/drill/scenarios.h"

namespace k3d::optimizer::drill {

namespace {

constexpr double kKickJump = 0.8;         // m/s gained at once by a ball that is kicked
constexpr double kKickSpeed = 1.5;        // m/s after it
constexpr double kKickReach = 0.7;        // m from the robot
constexpr double kRollLimit = 14.0;       // s until a kicked ball lies
constexpr double kLeastDistance = 2.5;    // m of a kick that counts as one
constexpr double kWrongWay = radians(30.0);
constexpr double kAfterwards = 1.5;       // s: a kick that fells the robot has failed
constexpr double kMidRange = 6.0;         // m, of the paper's distance factor

/// Watches for the kick: the ball gains speed beside the robot.
class KickWatch {
  public:
    /// Whether this frame is the first one after the kick.
    bool sees(const Truth& truth, double time, const Vec2& ball_velocity) {
        const double speed = ball_velocity.norm();
        const bool near =
            (truth.ball.head<2>() - truth.robot->pose.position).norm() < kKickReach;
        // A trainer's word moves the ball at once, too.
        const bool kicked = time > 3.0 * kFrameSeconds && near && speed > kKickSpeed &&
                            speed > speed_ + kKickJump;
        speed_ = speed;
        return kicked;
    }

  private:
    double speed_ = 0.0;
};

struct Kick {
    std::size_t at = 0;  ///< last moment before the ball was hit
    Vec2 from, to;
};

std::optional<Kick> find_kick(const std::vector<Moment>& moments) {
    KickWatch watch;
    for (std::size_t i = 1; i < moments.size(); ++i) {
        if (!watch.sees(moments[i].truth, moments[i].time, moments[i].ball_velocity)) continue;
        return Kick{i - 1, moments[i - 1].truth.ball.head<2>(),
                    moments.back().truth.ball.head<2>()};
    }
    return std::nullopt;
}

/// Goes on until the kicked ball lies, or nothing was kicked in time.
void watch_kick(Stage& stage, double limit) {
    KickWatch watch;
    Vec3 before = stage.truth().ball;
    double time = 0.0;
    const auto kicked = [&](const Truth& t) {
        time += kFrameSeconds;
        const Vec2 velocity = (t.ball - before).head<2>() / kFrameSeconds;
        before = t.ball;
        return watch.sees(t, time, velocity);
    };
    if (!stage.until(limit, kicked)) return;
    int still = 0;
    const double until = time + kAfterwards;
    stage.until(kRollLimit, [&](const Truth& t) {
        time += kFrameSeconds;
        still = (t.ball - before).head<2>().norm() < 1e-3 ? still + 1 : 0;
        before = t.ball;
        return still > 3 && time > until;
    });
}

/// Eq. (1) of the paper with either reading of its distance factor.
void add_fitness(const Kick& kick, const std::vector<Moment>& moments, const Vec2& target,
                 Measured& out) {
    const double off_deg = degrees(angle_at(kick.to, kick.from, target));
    const double angle_factor = std::exp2(-off_deg * off_deg / 180.0);
    const double distance = (kick.to - kick.from).norm();
    const double time_factor = moments.back().time;
    const bool failed = out.reason != "done";
    const auto fitness = [&](double distance_factor) {
        return failed ? -1.0 : distance_factor * angle_factor / time_factor;
    };
    out.metrics["fitness_capped"] = fitness(std::min(distance, kMidRange));
    out.metrics["fitness_literal"] = fitness(std::max(distance, kMidRange));
}

Measured measure_kick(const std::vector<Moment>& moments, const Vec2& target, double wanted) {
    Measured out;
    const std::optional<Kick> kick = find_kick(moments);
    out.metrics["succeeded"] = 0.0;
    out.metrics["falls"] = count_falls(moments);
    if (!kick) {
        out.reason = count_falls(moments) > 0 ? "fell" : "no_kick";
        out.metrics["fitness_capped"] = out.metrics["fitness_literal"] = -1.0;
        return out;
    }
    const double distance = (kick->to - kick->from).norm();
    const double off = angle_at(kick->to, kick->from, target);
    const bool fell = count_falls(moments) > 0;
    out.reason = fell                        ? "fell"
                 : distance < kLeastDistance ? "short"
                 : off > kWrongWay           ? "wrong_way"
                                             : "done";
    out.metrics["succeeded"] = out.reason == "done" ? 1.0 : 0.0;
    out.metrics["time_to_kick_s"] = moments[kick->at].time;
    out.metrics["distance_m"] = distance;
    out.metrics["direction_error_deg"] = degrees(off);
    out.metrics["within_1m_of_wanted"] = std::abs(distance - wanted) <= 1.0 ? 1.0 : 0.0;
    out.metrics["target_error_m"] = (kick->to - target).norm();
    add_fitness(*kick, moments, target, out);
    add_finish_errors(moments, kick->at + 1, "finish", out);
    return out;
}

std::vector<std::string> kick_settings(const char* task, const Vec2& target) {
    return {fmt::format("drill.task={}", task), fmt::format("drill.target_x={:.4f}", target.x()),
            fmt::format("drill.target_y={:.4f}", target.y())};
}

}  // namespace

Plan plan_kick(const spec::DrillSpec& spec, int, RandomStream& random) {
    const spec::DrillSetup s = spec.setup;
    const Pose2 robot{{random.uniform(-8.0, -6.0), random.uniform(-2.0, 2.0)},
                      random.uniform(-kPi, kPi)};
    const double bearing = radians(s.ball_bearing_deg) * random.uniform(-1.0, 1.0);
    const Vec2 ball = robot.to_global(direction(bearing) * s.ball_distance);
    const double turn = radians(s.target_turn_deg) * random.uniform(-1.0, 1.0);
    const Vec2 target = ball + direction(robot.yaw + bearing + turn) * s.target_distance;
    Plan plan;
    plan.agent_settings = kick_settings("kick", target);
    plan.act = [=](Stage& stage) {
        stage.begin(robot, ball_at(ball));
        watch_kick(stage, s.kick_limit_s);
    };
    plan.measure = [=](const std::vector<Moment>& moments) {
        return measure_kick(moments, target, s.target_distance);
    };
    return plan;
}

Plan plan_kick_task(const spec::DrillSpec& spec, int index, RandomStream&) {
    const Scenario scenario = scenario_of(spec.scenarios, index);
    const double limit = spec.setup.kick_limit_s;
    Plan plan;
    plan.agent_settings = kick_settings("kick", scenario.target);
    plan.act = [=](Stage& stage) {
        stage.begin(scenario.robot, ball_at(Vec2::Zero(), scenario.ball_velocity));
        watch_kick(stage, limit);
    };
    plan.measure = [=](const std::vector<Moment>& moments) {
        return measure_kick(moments, scenario.target, kMidRange);
    };
    return plan;
}

}  // namespace k3d::optimizer::drill
