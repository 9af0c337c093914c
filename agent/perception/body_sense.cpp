// SPDX-License-Identifier: BSD-3-Clause
#include "agent/perception/body_sense.h"

namespace k3d::agent::perception {

namespace {

constexpr double kRadPerDeg = radians(1.0);

std::optional<motion::SoleForce> sole(const wire::Percepts& percepts, wire::FootSensor sensor) {
    const auto& felt = percepts.feet[static_cast<std::size_t>(sensor)];
    if (!felt) return std::nullopt;
    return motion::SoleForce{agent_axes(felt->point), agent_axes(felt->force)};
}

}  // namespace

void body_sense(const wire::Percepts& percepts, motion::BodySense& sense) {
    sense.time = percepts.time;
    for (std::size_t k = 0; k < nao::kJointCount; ++k) {
        if (percepts.has_joint[k]) sense.joints[k] = percepts.joints_deg[k] * kRadPerDeg;
    }
    sense.gyro = agent_axes(percepts.gyro_deg) * kRadPerDeg;
    sense.acceleration = agent_axes(percepts.acceleration);
    sense.right_sole = sole(percepts, wire::FootSensor::Right);
    sense.left_sole = sole(percepts, wire::FootSensor::Left);
}

}  // namespace k3d::agent::perception
