// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/keepaway/start.h"

#include <algorithm>
#include <limits>

namespace k3d::server::game {

namespace {

Pose2 facing_centre(const Vec2& position) { return {position, yaw_of(-position)}; }

Vec2 jittered(const Vec2& v, double jitter, RandomStream& random) {
    const double dx = random.uniform(-jitter, jitter);
    const double dy = random.uniform(-jitter, jitter);
    return v + Vec2(dx, dy);
}

void jitter_pose(Pose2& pose, const KeepawayConfig& config, RandomStream& random) {
    pose.position = jittered(pose.position, config.jitter, random);
    const double turn = radians(config.jitter_yaw_deg);
    pose.yaw = wrap_angle(pose.yaw + random.uniform(-turn, turn));
}

double nearest_taker(const Vec2& position, const std::vector<Pose2>& takers) {
    double nearest = std::numeric_limits<double>::max();
    for (const Pose2& taker : takers) {
        nearest = std::min(nearest, (taker.position - position).norm());
    }
    return nearest;
}

}  // namespace

Start make_start(const KeepawayConfig& config, RandomStream random) {
    Start start;
    const double radius = kStartRadiusPerSide * config.start_side();
    for (int k = 0; k < config.keepers; ++k) {
        const double angle = radians(90.0 + 360.0 * k / config.keepers);
        start.keepers.push_back(facing_centre(radius * direction(angle)));
    }
    const double edge = config.start_side() / 2.0 - kCornerInset;
    for (int k = 0; k < config.takers; ++k) {
        const double share = config.takers == 1 ? 0.5 : 1.0 * k / (config.takers - 1);
        start.takers.push_back(facing_centre({edge, edge * (1.0 - 2.0 * share)}));
    }
    const auto farthest = std::max_element(
        start.keepers.begin(), start.keepers.end(), [&](const Pose2& a, const Pose2& b) {
            return nearest_taker(a.position, start.takers) <
                   nearest_taker(b.position, start.takers) - 1e-9;  // ties: the first
        });
    start.ball = farthest->to_global({kBallAhead, 0.0});
    for (Pose2& pose : start.keepers) jitter_pose(pose, config, random);
    for (Pose2& pose : start.takers) jitter_pose(pose, config, random);
    start.ball = jittered(start.ball, config.jitter, random);
    return start;
}

}  // namespace k3d::server::game
