// SPDX-License-Identifier: BSD-3-Clause
// What all drills measure, on tracks made by hand.
#include "optimizer/drill/plan.h"

#include <gtest/gtest.h>

#include <set>

#include "optimizer/drill/scenarios.h"
#include "optimizer/spec/figures.h"
#include "optimizer/spec/task_spec.h"

namespace k3d::optimizer::drill {
namespace {

Moment moment(double time, double up, const Vec2& ball) {
    Moment m;
    m.time = m.truth.time = time;
    m.truth.robot = RobotTruth{{0, 0, 0.38}, {}, up};
    m.truth.ball = {ball.x(), ball.y(), 0.04};
    m.belief = Belief{};
    m.belief->localised = true;
    return m;
}

TEST(DrillPlan, AFallCountsOnceUntilUpright) {
    std::vector<Moment> moments;
    for (const double up : {1.0, 0.4, 0.7, 0.3, 0.95, 0.2}) {
        moments.push_back(moment(0.04 * static_cast<double>(moments.size()), up, {}));
    }
    EXPECT_EQ(count_falls(moments), 2);
}

TEST(DrillPlan, EstimateErrorsAreOfWhatIsSeenWhileUpright) {
    std::vector<Moment> moments{moment(1.0, 1.0, {2.0, 0.0}), moment(1.04, 1.0, {2.0, 0.0})};
    moments[0].belief->pose = {{0.3, 0.4}, radians(10.0)};
    moments[0].belief->ball = Belief::Ball{{2.0, 0.1}, {}, 0.0};
    moments[1].belief->pose = {{0.1, 0.0}, radians(-2.0)};
    moments[1].belief->ball = Belief::Ball{{9.0, 9.0}, {}, 3.0};  // remembered, not in view
    Measured out;
    add_estimate_errors(moments, out);
    EXPECT_NEAR(out.metrics.at("position_error_m"), 0.3, 1e-12);
    EXPECT_NEAR(out.metrics.at("yaw_error_deg"), 6.0, 1e-9);
    EXPECT_NEAR(out.metrics.at("ball_error_percent"), 5.0, 1e-9);
    moments[0].truth.robot->up = 0.0;
    Measured down;
    add_estimate_errors(moments, down);
    EXPECT_NEAR(down.metrics.at("position_error_m"), 0.1, 1e-12);
}

TEST(DrillPlan, FinishErrorsAreTakenAtTheirTimes) {
    std::vector<Moment> moments;
    for (int i = 0; i <= 20; ++i) {
        Moment m = moment(0.04 * i, 1.0, {0.1 * i, 0.0});
        m.ball_velocity = {2.5, 0.0};
        // The prediction comes nearer by 5 cm a frame; the roll ends at x = 2.
        m.belief->ball = Belief::Ball{{}, {2.0, 1.0 - 0.05 * i}, 0.0};
        moments.push_back(m);
    }
    Measured out;
    add_finish_errors(moments, 0, "finish", out);
    EXPECT_NEAR(out.metrics.at("finish_error_0.2s_m"), 0.75, 1e-9);
    EXPECT_NEAR(out.metrics.at("finish_error_0.5s_m"), 0.35, 1e-9) << "at 0.52 s";
    EXPECT_EQ(out.metrics.count("finish_error_1.0s_m"), 0U);
    EXPECT_GT(out.metrics.at("finish_loss"), 0.0);
}

/// A ball that lies, is kicked, rolls for four seconds and lies again, watched all the time by a robot
/// that is on its way to one target and then to another.
std::vector<Moment> kick_and_roll() {
    std::vector<Moment> moments;
    double x = 0.2;
    for (int i = 0; i <= 150; ++i) {
        const bool rolls = i > 10 && i <= 110;
        if (rolls) x += 0.08;
        Moment m = moment(0.04 * i, 1.0, {x, 0.0});
        m.ball_velocity = {rolls ? 2.0 : 0.0, 0.0};
        m.belief->upright = true;
        m.belief->ball = Belief::Ball{{x, 0.0}, {8.0, 0.0}, 0.0};
        m.belief->target = Vec2(i < 75 ? 3.0 : 5.0, 0.0);
        moments.push_back(m);
    }
    return moments;
}

TEST(DrillPlan, MeasuresTheFiguresThatATaskIsKnownFor) {
    const std::vector<Moment> moments = kick_and_roll();
    for (const std::string& task : spec::kTaskNames) {
        spec::DrillSpec spec;
        spec.name = spec::drill_of(task);
        if (spec.name.empty()) continue;
        RandomStream random(spec.seed, spec.name, "drill");
        Measured measured = plan(spec, 0, random).measure(moments);
        add_estimate_errors(moments, measured);
        std::set<std::string> names{"hold_time_s", "attempts", "kicks", "passes_completed", "falls",
                                    "simulated_s"};
        for (const auto& [name, value] : measured.metrics) names.insert(name);
        EXPECT_EQ(std::vector(names.begin(), names.end()), spec::figures_of(task)) << task;
    }
}

TEST(BallRolls, WithOddSeedsASecondRobotKicksTheBall) {
    spec::DrillSpec spec;
    spec.name = "ball_rolls";
    for (const std::uint64_t seed : {6U, 7U}) {
        spec.seed = seed;
        for (const int index : {0, 1}) {
            RandomStream random(seed, spec.name, "drill");
            const bool odd = (seed + static_cast<std::uint64_t>(index)) % 2 == 1;
            EXPECT_EQ(plan(spec, index, random).second_settings.empty(), !odd) << seed << " " << index;
        }
    }
    spec.setup.roll_kicked = false;
    RandomStream random(7, spec.name, "drill");
    EXPECT_TRUE(plan(spec, 0, random).second_settings.empty());
}

/// Moments of a ball that rolls along x, of these speeds in m/s.
std::vector<Moment> rolling(const std::vector<double>& speeds) {
    std::vector<Moment> moments;
    Vec3 ball(-5.0, 0.0, 0.042);
    for (const double speed : speeds) {
        Moment moment;
        moment.time = static_cast<double>(moments.size()) * kFrameSeconds;
        moment.ball_velocity = {speed, 0.0};
        ball.x() += speed * kFrameSeconds;
        moment.truth.ball = ball;
        moments.push_back(moment);
    }
    return moments;
}

TEST(BallRolls, AreMeasuredFromTheLastTouchOn) {
    spec::DrillSpec spec;
    spec.name = "ball_rolls";
    spec.seed = 7;
    RandomStream random(7, spec.name, "drill");
    const Plan kicked = plan(spec, 0, random);
    ASSERT_FALSE(kicked.second_settings.empty());
    const std::vector<double> pushed{0.0, 0.0, 1.6, 1.5, 1.4, 1.3};
    const std::vector<double> struck{3.0, 4.0, 3.5, 3.0, 2.5, 2.0, 1.5, 1.0, 0.5, 0.0};
    std::vector<double> both = pushed;
    both.insert(both.end(), struck.begin(), struck.end());
    const Measured measured = kicked.measure(rolling(both));
    EXPECT_EQ(measured.reason, "done");
    EXPECT_NEAR(measured.metrics.at("ball_speed_mps"), 3.5, 1e-9);
    const double rolled = (4.0 + 3.5 + 3.0 + 2.5 + 2.0 + 1.5 + 1.0 + 0.5) * kFrameSeconds;
    EXPECT_NEAR(measured.metrics.at("rolled_m"), rolled, 1e-9);
    EXPECT_EQ(kicked.measure(rolling({0.0, 0.3, 0.2, 0.0})).reason, "no_kick");
}

TEST(Scenarios, TablesAreDisjointAndWithinTheField) {
    std::vector<Scenario> all;
    for (const char* table : {"train", "validation", "test"}) {
        for (int i = 0; i < kScenarios; ++i) all.push_back(scenario_of(table, i));
        EXPECT_EQ(scenario_of(table, kScenarios + 3).target, scenario_of(table, 3).target);
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_LT(std::abs(all[i].target.x()), 14.0);
        EXPECT_LT(std::abs(all[i].target.y()), 9.0);
        for (std::size_t k = 0; k < i; ++k) EXPECT_NE(all[i].target, all[k].target);
    }
}

}  // namespace
}  // namespace k3d::optimizer::drill
