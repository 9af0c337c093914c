// SPDX-License-Identifier: BSD-3-Clause
#include "agent/motion/joint_control.h"

#include <algorithm>

#include "common/clock/clock.h"

namespace k3d::agent::motion {

namespace {

// The server ignores commands to a joint outside its stops, and stops bounce; stay clear of them.
constexpr double kStopMargin = radians(0.3);

}  // namespace

void JointControl::step(const nao::JointArray& measured, const JointTargets& targets,
                        nao::JointArray& rates) {
    rates.fill(0.0);
    for (const nao::JointDef& joint : model_.joints) {
        const std::size_t i = nao::index(joint.id);
        // At the end of the running cycle.
        const double expected = measured[i] + previous_[i] * kCycleSeconds;
        const double target =
            std::clamp(targets.angle[i], joint.min + kStopMargin, joint.max - kStopMargin);
        rates[i] = std::clamp((target - expected) / kCycleSeconds, -joint.max_rate, joint.max_rate);
    }
    previous_ = rates;
}

}  // namespace k3d::agent::motion
