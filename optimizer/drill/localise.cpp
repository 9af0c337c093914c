// SPDX-License-Identifier: BSD-3-Clause
// Where am I: while walking about, after a kidnap and after a fall.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/math/sample.h"
#include "optimizer/drill/plan.h"

namespace k3d::optimizer::drill {

namespace {

constexpr double kFoundPosition = 0.25;        // m: knows again where it is
constexpr double kFoundYaw = radians(10.0);
constexpr double kJump = 0.5;                  // m in one frame: a kidnap
constexpr double kStands = 0.97;               // cosine of the tilt of who stands again

bool found(const Moment& m) {
    if (!m.belief) return false;
    const Pose2& truth = m.truth.robot->pose;
    return (m.belief->pose.position - truth.position).norm() < kFoundPosition &&
           std::abs(wrap_angle(m.belief->pose.yaw - truth.yaw)) < kFoundYaw;
}

/// After each fall, from standing again until it knows where it is, s.
std::vector<double> times_after_falls(const std::vector<Moment>& moments) {
    std::vector<double> times;
    bool down = false;
    std::optional<double> up;
    for (const Moment& m : moments) {
        if (is_down(m.truth)) {
            down = true;
            up.reset();
        } else if (down && m.truth.robot->up > kStands) {
            down = false;
            up = m.time;
        }
        if (!up || !found(m)) continue;
        times.push_back(m.time - *up);
        up.reset();
    }
    if (up) times.push_back(moments.back().time - *up);  // never found
    return times;
}

Measured measure_localisation(const std::vector<Moment>& moments) {
    Measured out;
    std::vector<double> position, yaw_deg, recovery;
    std::optional<double> lost = 0.0;  // since when
    for (std::size_t i = 1; i < moments.size(); ++i) {
        const Moment& m = moments[i];
        const Pose2& truth = m.truth.robot->pose;
        const Pose2& before = moments[i - 1].truth.robot->pose;
        if ((truth.position - before.position).norm() > kJump) {
            if (lost && *lost > 0.0) recovery.push_back(m.time - *lost);  // never found
            lost = m.time;
        }
        if (!m.belief) continue;
        if (lost && found(m)) {
            if (*lost > 0.0) recovery.push_back(m.time - *lost);
            lost.reset();
        }
        if (lost || is_down(m.truth)) continue;
        position.push_back((m.belief->pose.position - truth.position).norm());
        yaw_deg.push_back(std::abs(degrees(wrap_angle(m.belief->pose.yaw - truth.yaw))));
    }
    if (lost && *lost > 0.0) recovery.push_back(moments.back().time - *lost);
    out.reason = "done";
    if (!position.empty()) {
        out.metrics["known_position_error_m"] = mean_of(position);
        out.metrics["known_position_error_95_m"] = quantile(position, 0.95);
        out.metrics["known_yaw_error_deg"] = mean_of(yaw_deg);
    }
    if (!recovery.empty()) {
        out.metrics["recovery_s"] = mean_of(recovery);
        out.metrics["recovery_longest_s"] = quantile(recovery, 1.0);
    }
    if (const std::vector<double> after = times_after_falls(moments); !after.empty()) {
        out.metrics["known_after_fall_s"] = mean_of(after);
        out.metrics["known_after_fall_longest_s"] = quantile(after, 1.0);
    }
    out.metrics["falls"] = count_falls(moments);
    return out;
}

}  // namespace

Plan plan_localise(const spec::DrillSpec& spec, int, RandomStream& random) {
    const spec::DrillSetup s = spec.setup;
    const auto somewhere = [&random] {
        return Pose2{{random.uniform(-12.0, -2.0), random.uniform(-8.0, 8.0)},
                     random.uniform(-kPi, kPi)};
    };
    std::vector<Pose2> places{somewhere()};
    if (s.kidnap_every_s > 0.0) {
        for (double t = s.kidnap_every_s; t < s.localise_s; t += s.kidnap_every_s)
            places.push_back(somewhere());
    }
    Plan plan;
    plan.agent_settings = {"drill.task=go_to",
                           fmt::format("drill.half_area={}", s.go_to_half_area),
                           fmt::format("drill.shortest={}", s.go_to_shortest),
                           fmt::format("drill.longest={}", s.go_to_longest),
                           fmt::format("drill.fall_every={}", s.fall_every_s)};
    plan.act = [=](Stage& stage) {
        const auto never = [](const Truth&) { return false; };
        stage.begin(places.front(), ball_at({-5.0, 0.0}));
        const double every = places.size() > 1 ? s.kidnap_every_s : s.localise_s;
        stage.until(every, never);
        for (std::size_t i = 1; i < places.size(); ++i) {
            stage.place(places[i]);
            stage.until(std::min(every, s.localise_s - static_cast<double>(i) * every), never);
        }
    };
    plan.measure = measure_localisation;
    return plan;
}

}  // namespace k3d::optimizer::drill
