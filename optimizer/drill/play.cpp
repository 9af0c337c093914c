// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/drill/play.h"

#include <algorithm>

#include "common/version/version.h"
#include "optimizer/drill/plan.h"

namespace k3d::optimizer::drill {

namespace {

k3d::episode::PlayerResult player_of(const std::vector<Moment>& moments) {
    k3d::episode::PlayerResult player{"left", 1, count_falls(moments), 0.0, 0.0};
    for (std::size_t i = 1; i < moments.size(); ++i) {
        player.distance_m += (moments[i].truth.robot->pose.position -
                              moments[i - 1].truth.robot->pose.position)
                                 .norm();
    }
    if (moments.back().time > 0.0) player.mean_speed = player.distance_m / moments.back().time;
    return player;
}

}  // namespace

k3d::episode::Result play(const spec::DrillSpec& spec, int index, const std::string& folder,
                          int http_port, const Listener& listener) {
    const std::uint64_t seed = spec.seed + static_cast<std::uint64_t>(index);
    RandomStream random(seed, spec.name, "drill");
    const Plan plan = drill::plan(spec, index, random);
    Stage stage(spec, seed, plan.agent_settings, plan.second_settings, folder, http_port, listener);
    if (stage.page_port() >= 0) listener.page(stage.page_port());
    plan.act(stage);
    stage.finish();
    const std::vector<Moment> moments = join(stage.track(), stage.telemetry_file());

    Measured measured = plan.measure(moments);
    add_estimate_errors(moments, measured);
    k3d::episode::Result result;
    result.game = "drill_" + spec.name;
    result.seed = seed;
    result.reason = measured.reason;
    result.hold_time_s = moments.back().time;
    int attempts = 0;
    for (const Moment& m : moments) {
        if (m.belief) attempts = std::max(attempts, m.belief->kicks);
    }
    result.attempts = attempts;
    result.players = {player_of(moments)};
    result.metrics = std::move(measured.metrics);
    result.metrics.emplace("falls", result.players.front().falls);
    result.metrics["simulated_s"] = result.hold_time_s;
    result.state_hash = stage.hash();
    result.code_version = code_version();
    return result;
}

}  // namespace k3d::optimizer::drill
