// SPDX-License-Identifier: BSD-3-Clause
// Vectors, angles and planar poses shared by all programs.
//
// Units: metres, radians, seconds; degrees only where a name ends in _deg.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace k3d {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

inline constexpr double kPi = std::numbers::pi;

constexpr double radians(double degrees) { return degrees * (kPi / 180.0); }
constexpr double degrees(double radians) { return radians * (180.0 / kPi); }

/// The same angle in (-pi, pi].
inline double wrap_angle(double angle) {
    if (angle > -kPi && angle <= kPi) return angle;  // mostly; the rest is a loop of subtractions
    const double wrapped = std::remainder(angle, 2.0 * kPi);
    return wrapped <= -kPi ? wrapped + 2.0 * kPi : wrapped;
}

/// The same angle in (-180, 180].
inline double wrap_degrees(double angle_deg) {
    if (angle_deg > -180.0 && angle_deg <= 180.0) return angle_deg;
    const double wrapped = std::remainder(angle_deg, 360.0);
    return wrapped <= -180.0 ? wrapped + 360.0 : wrapped;
}

inline double squared(double x) {
    return x * x;
}

/// Rotations about the axes, by the right-hand rule.
inline Mat3 about_x(double angle) {
    return Eigen::AngleAxisd(angle, Vec3::UnitX()).toRotationMatrix();
}
inline Mat3 about_y(double angle) {
    return Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix();
}
inline Mat3 about_z(double angle) {
    return Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
}

inline Vec2 direction(double yaw) { return {std::cos(yaw), std::sin(yaw)}; }
inline double yaw_of(const Vec2& v) { return std::atan2(v.y(), v.x()); }

inline Vec2 rotated(const Vec2& v, double yaw) {
    const double c = std::cos(yaw);
    const double s = std::sin(yaw);
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

/// The point of the square from -half to half on both axes that is nearest to `point`.
inline Vec2 within_square(const Vec2& point, double half) {
    return {std::clamp(point.x(), -half, half), std::clamp(point.y(), -half, half)};
}

/// Unsigned angle at the middle point `vertex`, 0..pi; 0 if a side has no length.
/// This is the paper's angle(A, B, C) with B = vertex.
inline double angle_at(const Vec2& a, const Vec2& vertex, const Vec2& c) {
    const Vec2 u = a - vertex;
    const Vec2 v = c - vertex;
    const double cross = u.x() * v.y() - u.y() * v.x();
    return std::abs(std::atan2(cross, u.dot(v)));
}

/// Position and heading on the ground plane. yaw 0 looks along +x, positive is counter-clockwise.
struct Pose2 {
    Vec2 position = Vec2::Zero();
    double yaw = 0.0;

    Vec2 to_global(const Vec2& local) const { return position + rotated(local, yaw); }
    Vec2 to_local(const Vec2& global) const { return rotated(global - position, -yaw); }
    /// This pose followed by `step`, which is given in this pose's frame.
    Pose2 then(const Pose2& step) const {
        return {to_global(step.position), wrap_angle(yaw + step.yaw)};
    }
};

}  // namespace k3d
