// SPDX-License-Identifier: BSD-3-Clause
#include "agent/motion/odometry.h"

namespace k3d::agent::motion {

Pose2 Odometry::update(const BodySense& sense, const Soles& soles, double turned) {
    const auto load = [](const std::optional<SoleForce>& sole) {
        return sole ? std::max(sole->force.z(), 0.0) : 0.0;
    };
    const double right = load(sense.right_sole);
    const double left = load(sense.left_sole);
    Pose2 step;
    step.yaw = started_ ? turned : 0.0;
    // A foot that carried weight before and carries it now stood still in between; where both did,
    // the heavier one counts more.
    const double right_share = right_stands_ ? right : 0.0;
    const double left_share = left_stands_ ? left : 0.0;
    if (started_ && right_share + left_share > 0.0) {
        const auto moved = [&](const Vec3& was, const Vec3& is) -> Vec2 {
            return was.head<2>() - rotated(is.head<2>(), turned);
        };
        step.position = (right_share * moved(before_.right, soles.right) +
                         left_share * moved(before_.left, soles.left)) /
                        (right_share + left_share);
    }
    before_ = soles;
    right_stands_ = right > 0.0;
    left_stands_ = left > 0.0;
    started_ = true;
    return step;
}

}  // namespace k3d::agent::motion
