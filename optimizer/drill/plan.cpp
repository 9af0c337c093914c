// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/drill/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/math/sample.h"

namespace k3d::optimizer::drill {

namespace {

constexpr double kDownCosine = 0.5;     // tilted by more than 60 degrees
constexpr double kUpCosine = 0.9;
constexpr double kRestSpeed = 0.03;     // m/s
constexpr double kSeenLately = 0.1;     // s: in view
constexpr double kNearBall = 6.0;       // m
constexpr double kFindYourself = 0.5;   // s after the start that do not count
const Vec2 kAway(10.0, 8.5);

}  // namespace

wire::BallCommand ball_at(const Vec2& position, const Vec2& velocity) {
    constexpr double kLying = 0.0403;  // m: a resting ball is sunk in by 1.7 mm (reference 5.5)
    return {Vec3(position.x(), position.y(), kLying), Vec3(velocity.x(), velocity.y(), 0.0)};
}

wire::BallCommand ball_away() { return ball_at(kAway); }

bool is_down(const Truth& truth) { return truth.robot && truth.robot->up < kDownCosine; }

bool is_at_rest(const Vec2& ball_velocity) { return ball_velocity.norm() < kRestSpeed; }

int count_falls(const std::vector<Moment>& moments) {
    int falls = 0;
    bool down = false;
    for (const Moment& m : moments) {
        if (!down && is_down(m.truth)) ++falls;
        down = down ? m.truth.robot->up < kUpCosine : is_down(m.truth);
    }
    return falls;
}

void add_estimate_errors(const std::vector<Moment>& moments, Measured& out) {
    std::vector<double> position, yaw_deg, ball;
    for (const Moment& m : moments) {
        if (!m.belief || m.time < kFindYourself) continue;
        const RobotTruth& robot = *m.truth.robot;
        if (robot.up >= kUpCosine && m.belief->upright) {
            position.push_back((m.belief->pose.position - robot.pose.position).norm());
            yaw_deg.push_back(std::abs(degrees(wrap_angle(m.belief->pose.yaw - robot.pose.yaw))));
        }
        const double distance = (m.truth.ball.head<2>() - robot.pose.position).norm();
        if (m.belief->ball && m.belief->ball->seen < kSeenLately && distance < kNearBall) {
            const Vec2 off = m.belief->ball->position - m.truth.ball.head<2>();
            ball.push_back(100.0 * off.norm() / distance);
        }
    }
    if (!position.empty()) {
        out.metrics["position_error_m"] = mean_of(position);
        out.metrics["position_error_95_m"] = quantile(position, 0.95);
        out.metrics["yaw_error_deg"] = mean_of(yaw_deg);
    }
    if (!ball.empty()) out.metrics["ball_error_percent"] = mean_of(ball);
}

void add_finish_errors(const std::vector<Moment>& moments, std::size_t from, const char* name,
                       Measured& out) {
    const Vec2 finish = moments.back().truth.ball.head<2>();
    std::vector<double> squares;
    for (std::size_t i = from; i < moments.size(); ++i) {
        const Moment& m = moments[i];
        if (!m.belief || !m.belief->ball) continue;
        const double after = m.time - moments[from].time;
        const double error = (m.belief->ball->finish - finish).norm();
        if (!is_at_rest(m.ball_velocity)) squares.push_back(error * error);
        for (const double mark : {0.2, 0.5, 1.0, 1.5, 2.0, 3.0}) {
            if (after < mark - 1e-6 || after > mark + kFrameSeconds - 2e-6) continue;
            out.metrics[fmt::format("{}_error_{:.1f}s_m", name, mark)] = error;
        }
    }
    if (!squares.empty()) out.metrics[fmt::format("{}_loss", name)] = mean_of(squares);
}

Plan plan(const spec::DrillSpec& spec, int index, RandomStream& random) {
    const std::string& name = spec.name;
    if (name == "turn") return plan_turn(spec, index, random);
    if (name == "go_to") return plan_go_to(spec, index, random);
    if (name == "localise") return plan_localise(spec, index, random);
    if (name == "getup") return plan_get_up(spec, index, random);
    if (name == "kick") return plan_kick(spec, index, random);
    if (name == "kick_task") return plan_kick_task(spec, index, random);
    if (name == "intercept") return plan_intercept(spec, index, random);
    if (name == "ball_rolls") return plan_ball_rolls(spec, index, random);
    return plan_walk(spec, index, random);
}

}  // namespace k3d::optimizer::drill
