// SPDX-License-Identifier: BSD-3-Clause
#include "agent/localisation/sensed_poses.h"

#include <algorithm>

namespace k3d::agent::localisation {

namespace {

constexpr double kMargin = 3.0;        // m around the field where a robot may still stand
constexpr double kChordLength = 1.25;  // m: shorter pieces may belong to the centre circle

void add(const Pose2& pose, SensedPoses& poses) {
    const bool near = std::abs(pose.position.x()) < field::kLength / 2.0 + kMargin &&
                      std::abs(pose.position.y()) < field::kWidth / 2.0 + kMargin;
    if (near) poses.pose[static_cast<std::size_t>(poses.count++)] = pose;
}

const Vec2& truth_of(const perception::LandmarkSight& sight, const Landmarks& landmarks) {
    return landmarks[static_cast<std::size_t>(sight.landmark)];
}

/// Rigid alignment of the seen constellation with the true one.
Pose2 aligned(const perception::View& view, const Landmarks& landmarks) {
    Vec2 seen_mean = Vec2::Zero();
    Vec2 true_mean = Vec2::Zero();
    for (const auto& sight : view.landmarks) {
        seen_mean += sight.position;
        true_mean += truth_of(sight, landmarks);
    }
    const auto count = static_cast<double>(view.landmarks.size());
    seen_mean /= count;
    true_mean /= count;
    double dot = 0.0;
    double cross = 0.0;
    for (const auto& sight : view.landmarks) {
        const Vec2 seen = sight.position - seen_mean;
        const Vec2 truth = truth_of(sight, landmarks) - true_mean;
        dot += seen.dot(truth);
        cross += seen.x() * truth.y() - seen.y() * truth.x();
    }
    const double yaw = std::atan2(cross, dot);
    return {true_mean - rotated(seen_mean, yaw), yaw};
}

}  // namespace

SensedPoses sensed_poses(const perception::View& view, const Landmarks& landmarks) {
    SensedPoses poses;
    if (view.landmarks.size() >= 2) {
        add(aligned(view, landmarks), poses);
        return poses;
    }
    if (view.landmarks.empty() || view.lines.empty()) return poses;
    const auto longest =
        std::max_element(view.lines.begin(), view.lines.end(),
                         [](const auto& a, const auto& b) { return a.length < b.length; });
    if (longest->length <= kChordLength) return poses;
    const double line_yaw = yaw_of(longest->end - longest->begin);
    const auto& sight = view.landmarks.front();
    for (int quarter = 0; quarter < 4; ++quarter) {
        const double yaw = wrap_angle(quarter * kPi / 2.0 - line_yaw);
        add({truth_of(sight, landmarks) - rotated(sight.position, yaw), yaw}, poses);
    }
    return poses;
}

}  // namespace k3d::agent::localisation
