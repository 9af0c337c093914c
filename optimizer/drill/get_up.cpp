// SPDX-License-Identifier: BSD-3-Clause
// Getting up, after falls that the robot makes itself: a trainer can only place it upright.
#include <array>
#include <fmt/format.h>

#include "optimizer/drill/plan.h"

namespace k3d::optimizer::drill {

Plan plan_get_up(const spec::DrillSpec& spec, int index, RandomStream& random) {
    constexpr std::array<const char*, 2> kWays{"front", "back"};
    const char* way = kWays[static_cast<std::size_t>(index) % kWays.size()];
    const double limit = spec.setup.kick_limit_s;
    const double yaw = random.uniform(-kPi, kPi);
    const double before = random.uniform(0.0, 0.5);
    Plan plan;
    plan.agent_settings = {"drill.task=get_up", fmt::format("drill.fall={}", way)};
    constexpr double kUp = 0.97;        // cosine of the tilt of who stands
    constexpr double kHigh = 0.28;      // m, torso of who stands
    constexpr double kQuiet = 0.6;      // s of standing
    const auto stands = [](const Truth& t) {
        return t.robot->up > kUp && t.robot->torso.z() > kHigh;
    };
    plan.act = [=](Stage& stage) {
        stage.begin({{-7.0, 0.0}, yaw}, ball_away());
        if (!stage.until(5.0, is_down)) return;
        double since = -1.0;
        stage.until(limit, [&](const Truth& t) {
            if (!stands(t)) since = -1.0;
            else if (since < 0.0) since = t.time;
            return since >= 0.0 && t.time - since >= kQuiet + before;
        });
    };
    plan.measure = [=](const std::vector<Moment>& moments) {
        Measured out;
        std::optional<double> down, up;
        for (const Moment& m : moments) {
            if (!down && is_down(m.truth)) down = m.time;
            if (!stands(m.truth)) up.reset();
            else if (down && !up) up = m.time;
        }
        out.reason = !down ? "did_not_fall" : !up ? "did_not_get_up" : "done";
        if (down && up) out.metrics["up_after_s"] = *up - *down;
        out.metrics["up_within_5s"] = down && up && *up - *down <= 5.0 ? 1.0 : 0.0;
        out.metrics["falls"] = count_falls(moments);
        return out;
    };
    return plan;
}

}  // namespace k3d::optimizer::drill
