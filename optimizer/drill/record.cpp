// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/drill/record.h"

#include <cmath>
#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "optimizer/episode/telemetry.h"

namespace k3d::optimizer::drill {

namespace {

using Json = nlohmann::json;

/// Game time in cycles: both sides tell it with at least two decimals.
long cycle_of(double time) { return std::lround(time / 0.02); }

Vec2 point(const Json& j) { return {j.at("x").get<double>(), j.at("y").get<double>()}; }

Belief belief_of(const Json& j) {
    Belief b;
    const Json& pose = j.at("pose");
    b.pose = {point(pose), radians(pose.at("yaw_deg").get<double>())};
    b.localised = pose.at("localised").get<bool>();
    b.upright = j.at("upright").get<bool>();
    b.activity = j.at("activity").get<std::string>();
    b.kicks = j.at("kicks").get<int>();
    if (const Json& ball = j.at("ball"); !ball.is_null()) {
        b.ball = Belief::Ball{point(ball),
                              {ball.at("finish_x").get<double>(), ball.at("finish_y").get<double>()},
                              ball.at("seen").get<double>()};
    }
    if (const Json& target = j.at("target"); !target.is_null()) b.target = point(target);
    return b;
}

std::map<long, Belief> read(const std::string& file) {
    std::ifstream in(file);
    if (!in) throw episode::TelemetryError("no telemetry: " + file);
    std::map<long, Belief> beliefs;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        try {
            const Json j = Json::parse(line);
            if (j.at("event") != "belief" || j.at("mode") != "PlayOn") continue;
            beliefs[cycle_of(j.at("game_time").get<double>())] = belief_of(j);
        } catch (const Json::exception& error) {
            throw episode::TelemetryError(fmt::format("{}:{}: {}", file, number, error.what()));
        }
    }
    return beliefs;
}

}  // namespace

std::vector<Moment> join(const std::vector<Truth>& track, const std::string& telemetry_file) {
    const std::map<long, Belief> beliefs = read(telemetry_file);
    std::vector<Moment> moments;
    for (const Truth& truth : track) {
        Moment m;
        m.truth = truth;
        m.time = truth.time - track.front().time;
        if (!moments.empty() && truth.time > moments.back().truth.time) {
            const Truth& before = moments.back().truth;
            m.ball_velocity = (truth.ball - before.ball).head<2>() / (truth.time - before.time);
        }
        const auto found = beliefs.find(cycle_of(truth.time));
        if (found != beliefs.end()) m.belief = found->second;
        moments.push_back(std::move(m));
    }
    return moments;
}

}  // namespace k3d::optimizer::drill
