// SPDX-License-Identifier: BSD-3-Clause
// Walking straight, turning on the spot, walking to random places.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "optimizer/drill/plan.h"

namespace k3d::optimizer::drill {

namespace {

constexpr double kTopSpeed = 2.0;  // m/s and more than any walk has: the walk engine's own limits hold
constexpr double kTopTurn = 4.0;   // rad/s
constexpr double kMinute = 60.0;

/// A walk or its mirror image, run by run.
double side_of(int index) { return index % 2 == 0 ? 1.0 : -1.0; }

struct Course {
    const char* setting;
    Vec2 along;   ///< robot frame
    double sign;  ///< of the setting
    Vec2 start;
};

Course course(const spec::DrillSpec& spec, int index) {
    const double side = side_of(index);
    if (spec.name == "backward") return {"drill.forward", {-1.0, 0.0}, -1.0, {-1.0, 0.0}};
    if (spec.name == "sideways") return {"drill.left", {0.0, side}, side, {-7.0, -7.0 * side}};
    return {"drill.forward", {1.0, 0.0}, 1.0, {-14.0, 0.0}};
}

}  // namespace

Plan plan_walk(const spec::DrillSpec& spec, int index, RandomStream& random) {
    const Course c = course(spec, index);
    const double length = spec.setup.walk_m;
    const double limit = spec.setup.walk_limit_s;
    const double y = random.uniform(-1.0, 1.0);
    Plan plan;
    plan.agent_settings = {"drill.task=walk", fmt::format("{}={}", c.setting, c.sign * kTopSpeed)};
    plan.act = [=](Stage& stage) {
        const Pose2 start{{c.start.x(), c.start.y() + y}, 0.0};
        stage.begin(start, ball_away());
        stage.until(limit, [&](const Truth& t) {
            const Vec2 gone = t.robot->pose.position - stage.track().front().robot->pose.position;
            return gone.dot(c.along) >= length || is_down(t);
        });
    };
    plan.measure = [=](const std::vector<Moment>& moments) {
        Measured out;
        const Pose2& first = moments.front().truth.robot->pose;
        const Pose2& last = moments.back().truth.robot->pose;
        const double gone = (last.position - first.position).dot(c.along);
        const bool fell = count_falls(moments) > 0;
        out.reason = fell ? "fell" : gone < length ? "time_limit" : "done";
        out.metrics["speed_mps"] = gone / moments.back().time;
        out.metrics["distance_m"] = gone;
        const Vec2 across(-c.along.y(), c.along.x());
        out.metrics["drift_m"] = std::abs((last.position - first.position).dot(across));
        out.metrics["turned_deg"] = std::abs(degrees(wrap_angle(last.yaw - first.yaw)));
        return out;
    };
    return plan;
}

Plan plan_turn(const spec::DrillSpec& spec, int index, RandomStream& random) {
    const double side = side_of(index);
    const double seconds = spec.setup.turn_s;
    const double yaw = random.uniform(-kPi, kPi);
    Plan plan;
    plan.agent_settings = {"drill.task=walk", fmt::format("drill.turn={}", side * kTopTurn)};
    plan.act = [=](Stage& stage) {
        stage.begin({{-7.0, 0.0}, yaw}, ball_away());
        stage.until(seconds, is_down);
    };
    plan.measure = [=](const std::vector<Moment>& moments) {
        Measured out;
        double turned = 0.0;
        for (std::size_t i = 1; i < moments.size(); ++i) {
            turned += wrap_angle(moments[i].truth.robot->pose.yaw -
                                 moments[i - 1].truth.robot->pose.yaw);
        }
        out.reason = count_falls(moments) > 0 ? "fell" : "done";
        out.metrics["turn_deg_per_s"] = side * degrees(turned) / moments.back().time;
        out.metrics["drift_m"] = (moments.back().truth.robot->pose.position -
                                  moments.front().truth.robot->pose.position)
                                     .norm();
        return out;
    };
    return plan;
}

namespace {

/// Speed towards the targets: way gained towards each, until it is reached or the next one comes,
/// over the time that took.
struct Ways {
    double gained = 0.0;
    double time = 0.0;
    int targets = 0;
    int reached = 0;
};

Ways ways(const std::vector<Moment>& moments, double reached) {
    Ways total;
    std::optional<Vec2> target;
    double start = 0.0;      // s and m, of the way to this target
    double start_left = 0.0;
    bool over = true;
    const auto left = [&](const Moment& m) { return (*target - m.truth.robot->pose.position).norm(); };
    const auto end = [&](const Moment& m) {
        if (!target || over) return;
        over = true;
        total.gained += start_left - left(m);
        total.time += m.time - start;
    };
    for (const Moment& m : moments) {
        if (!m.belief || !m.belief->target) continue;
        if (!target || *m.belief->target != *target) {
            end(m);
            target = m.belief->target;
            start = m.time;
            start_left = left(m);
            over = start_left <= reached;
            ++total.targets;
            if (over) ++total.reached;
        } else if (!over && left(m) <= reached) {
            end(m);
            ++total.reached;
        }
    }
    return total;
}

}  // namespace

Plan plan_go_to(const spec::DrillSpec& spec, int, RandomStream& random) {
    const spec::DrillSetup s = spec.setup;
    const double yaw = random.uniform(-kPi, kPi);
    Plan plan;
    plan.agent_settings = {"drill.task=go_to",
                           fmt::format("drill.half_area={}", s.go_to_half_area),
                           fmt::format("drill.shortest={}", s.go_to_shortest),
                           fmt::format("drill.longest={}", s.go_to_longest)};
    plan.act = [=](Stage& stage) {
        stage.begin({{-7.0, 0.0}, yaw}, ball_away());
        stage.until(s.go_to_s, [](const Truth&) { return false; });
    };
    plan.measure = [=](const std::vector<Moment>& moments) {
        Measured out;
        const Ways w = ways(moments, s.go_to_reached);
        out.reason = "done";
        if (w.time > 0.0) out.metrics["speed_to_target_mps"] = w.gained / w.time;
        out.metrics["targets"] = w.targets;
        out.metrics["reached"] = w.reached;
        out.metrics["falls_per_10_min"] =
            count_falls(moments) * 10.0 * kMinute / moments.back().time;
        return out;
    };
    return plan;
}

}  // namespace k3d::optimizer::drill
