// SPDX-License-Identifier: BSD-3-Clause
#include "agent/localisation/refine.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "common/nao/camera.h"

namespace k3d::agent::localisation {

namespace {

constexpr double kDistanceNoise = nao::kSightDistanceNoise;
constexpr double kAngleNoise = radians(nao::kSightThetaNoiseDeg);
constexpr double kOffset =
    0.01;  // m: calibration (5 mm an axis), rounding, error of the camera pose
constexpr Gate kWide{0.8, 0.17};  // first look: parallel lines lie 1.8 m apart, chords 18 degrees
constexpr Gate kNarrow{0.25, 0.10};
constexpr int kIterations = 4;

/// Normal equations in (x, y, yaw).
struct Equations {
    Mat3 information;
    Vec3 rhs = Vec3::Zero();

    void add(const Vec3& row, double residual, double deviation) {
        const double weight = 1.0 / (deviation * deviation);
        information += weight * row * row.transpose();
        rhs -= weight * residual * row;
    }
};

double variance_of(double distance, double share) {
    return kOffset * kOffset + distance * distance * share * share;
}

void add_landmark(const Pose2& pose, const Vec2& seen, const Vec2& truth, Equations& equations) {
    const double distance = std::max(seen.norm(), 0.1);
    const Vec2 arm = rotated(seen, pose.yaw);
    const Vec2 error = pose.position + arm - truth;
    const Vec2 ray = arm / distance;
    const Vec2 side(-ray.y(), ray.x());
    equations.add({ray.x(), ray.y(), 0.0}, ray.dot(error),
                  std::sqrt(variance_of(distance, kDistanceNoise)));
    equations.add({side.x(), side.y(), distance}, side.dot(error),
                  std::sqrt(variance_of(distance, kAngleNoise)));
}

void add_line_end(const Pose2& pose, const Vec2& seen, const MapLine& line, Equations& equations) {
    const Vec2 arm = rotated(seen, pose.yaw);
    const double residual = line.normal.dot(pose.position + arm) - line.offset;
    const double along = line.normal.dot(arm);  // distance noise acts along the ray
    const double across = line.normal.dot(Vec2(-arm.y(), arm.x()));  // angle noise across it
    const double variance = kOffset * kOffset + along * along * kDistanceNoise * kDistanceNoise +
                            across * across * kAngleNoise * kAngleNoise;
    equations.add({line.normal.x(), line.normal.y(), across}, residual, std::sqrt(variance));
}

bool explained(const Pose2& pose, const Vec2& seen, const Vec2& truth) {
    return (pose.to_global(seen) - truth).norm() < 0.2 + 0.02 * seen.norm();
}

}  // namespace

Fit refine(const perception::View& view, const Landmarks& landmarks, const Estimate& prior) {
    Fit fit;
    fit.estimate = prior;
    Pose2& pose = fit.estimate.pose;
    const Mat3 prior_information = prior.covariance.inverse();
    for (int pass = 0; pass < kIterations; ++pass) {
        const Vec3 moved(pose.position.x() - prior.pose.position.x(),
                         pose.position.y() - prior.pose.position.y(),
                         wrap_angle(pose.yaw - prior.pose.yaw));
        Equations equations{prior_information, -prior_information * moved};
        for (const auto& sight : view.landmarks) {
            const Vec2& truth = landmarks[static_cast<std::size_t>(sight.landmark)];
            add_landmark(pose, sight.position, truth, equations);
        }
        for (const auto& sight : view.lines) {
            const MapLine* line = match(pose, sight, pass == 0 ? kWide : kNarrow);
            if (line == nullptr) continue;
            add_line_end(pose, sight.begin, *line, equations);
            add_line_end(pose, sight.end, *line, equations);
        }
        const Vec3 step = equations.information.llt().solve(equations.rhs);
        if (!step.allFinite()) break;
        pose.position += step.head<2>();
        pose.yaw = wrap_angle(pose.yaw + step.z());
        fit.estimate.covariance = equations.information.inverse();
        if (pass > 0 && step.head<2>().norm() < 1e-3 && std::abs(step.z()) < 1e-4) break;
    }
    int lines = 0;
    for (const auto& sight : view.lines) lines += match(pose, sight, kNarrow) != nullptr;
    for (const auto& sight : view.landmarks) {
        const Vec2& truth = landmarks[static_cast<std::size_t>(sight.landmark)];
        fit.landmarks += explained(pose, sight.position, truth);
    }
    fit.sightings = static_cast<int>(view.landmarks.size() + view.lines.size());
    const auto total = static_cast<double>(2 * view.landmarks.size() + view.lines.size());
    fit.share = total > 0.0 ? (2 * fit.landmarks + lines) / total : 0.0;
    return fit;
}

}  // namespace k3d::agent::localisation
