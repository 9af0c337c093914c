// SPDX-License-Identifier: BSD-3-Clause
#include "agent/perception/level.h"

#include <Eigen/Cholesky>

#include "common/nao/camera.h"

namespace k3d::agent::perception {

namespace {

constexpr double kTiltPrior = radians(3.0);
constexpr double kHeightPrior = 0.03;               // m
constexpr double kVerticalNoise = radians(nao::kSightPhiNoiseDeg);  // of one sighting
constexpr double kHeightNoise = 0.005;              // m: rounding to centimetres on the wire
constexpr double kMaxTilt = radians(10.0);

}  // namespace

Quat level(std::span<const Vec3> ground, double camera_height) {
    // Unknowns: small rotation (wx, wy) and height error h. A point p turned by w has the height
    // z + wx*y - wy*x, which should be -camera_height - h.
    Mat3 information = Vec3(1.0 / (kTiltPrior * kTiltPrior), 1.0 / (kTiltPrior * kTiltPrior),
                            1.0 / (kHeightPrior * kHeightPrior))
                           .asDiagonal();
    Vec3 rhs = Vec3::Zero();
    for (const Vec3& p : ground) {
        const double along = kVerticalNoise * kVerticalNoise * p.squaredNorm();
        const double weight = 1.0 / (along + kHeightNoise * kHeightNoise);
        const Vec3 row(p.y(), -p.x(), 1.0);
        information += weight * row * row.transpose();
        rhs += weight * (-camera_height - p.z()) * row;
    }
    const Vec3 best = information.llt().solve(rhs);
    const Vec3 tilt(best.x(), best.y(), 0.0);
    const double angle = tilt.norm();
    if (angle < 1e-9 || angle > kMaxTilt) return Quat::Identity();
    return Quat(Eigen::AngleAxisd(angle, tilt / angle));
}

}  // namespace k3d::agent::perception
