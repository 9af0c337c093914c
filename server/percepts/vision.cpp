// SPDX-License-Identifier: BSD-3-Clause
#include "server/percepts/vision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "common/field/field.h"

namespace k3d::server::percepts {

namespace {

/// Points on the edge of the pyramid must still count as inside after rounding.
constexpr double kEdgeToleranceDeg = 1e-6;

wire::Pol polar(const Vec3& in_head) {
    return {in_head.norm(), wrap_degrees(degrees(std::atan2(in_head.y(), in_head.x())) - 90.0),
            degrees(std::atan2(in_head.z(), std::hypot(in_head.x(), in_head.y())))};
}

bool in_view(const wire::Pol& pol) {
    const double limit = kViewHalfAngleDeg + kEdgeToleranceDeg;
    return std::abs(pol.theta_deg) <= limit && std::abs(pol.phi_deg) <= limit;
}

}  // namespace

/// Field frame -> head frame, with the camera's calibration error.
struct Camera::View {
    Vec3 origin;
    Mat3 to_head;
    Vec3 calibration;

    Vec3 operator()(const Vec3& point) const { return to_head * (point - origin) + calibration; }
};

Camera::Camera(const VisionConfig& config, RandomStream noise) : config_(config), noise_(noise) {
    if (!config_.noise) return;
    for (int axis = 0; axis < 3; ++axis) {
        calibration_[axis] = noise_.uniform(-kCalibrationRange, kCalibrationRange);
    }
}

wire::Pol Camera::noisy(const Vec3& in_head) {
    wire::Pol pol = polar(in_head);
    if (!config_.noise) return pol;
    pol.distance *= 1.0 + noise_.normal(0.0, kDistanceNoise);
    pol.theta_deg += noise_.normal(0.0, kThetaNoiseDeg);
    pol.phi_deg += noise_.normal(0.0, kPhiNoiseDeg);
    return pol;
}

std::optional<wire::Pol> Camera::look_at(const View& view, const Vec3& point) {
    if ((point - view.origin).norm() <= kMinSeenDistance) return std::nullopt;
    const Vec3 in_head = view(point);
    if (!in_view(polar(in_head))) return std::nullopt;
    return noisy(in_head);
}

void Camera::see_landmarks(const View& view, wire::See& out) {
    for (std::size_t i = 0; i < field::kLandmarks.size(); ++i) {
        const field::LandmarkDef& mark = field::kLandmarks[i];
        out.landmarks[i] = look_at(view, {mark.x, mark.y, mark.z});
    }
}

void Camera::see_players(const View& view, const body::Scene& scene, wire::See& out) {
    for (const auto& other : scene.players) {
        if (other->team == wire::Side::None) continue;
        const nao::Model& model = other->robot->model();
        const auto part = [&](nao::Part which) {
            const auto body = static_cast<std::size_t>(*model.body_of(which));
            return look_at(view, other->robot->position(body));
        };
        wire::SeenPlayer seen;
        seen.team = other->team_name;
        seen.unum = other->unum;
        seen.head = part(nao::Part::Head);
        seen.rlowerarm = part(nao::Part::RLowerArm);
        seen.llowerarm = part(nao::Part::LLowerArm);
        seen.rfoot = part(nao::Part::RFoot);
        seen.lfoot = part(nao::Part::LFoot);
        if (seen.head || seen.rlowerarm || seen.llowerarm || seen.rfoot || seen.lfoot) {
            out.players.push_back(std::move(seen));
        }
    }
}

void Camera::see_lines(const View& view, wire::See& out) {
    for (const field::Line& line : field::lines()) {
        Vec3 begin = view({line.begin.x(), line.begin.y(), 0.0});
        Vec3 end = view({line.end.x(), line.end.y(), 0.0});
        if (!clip_to_view(begin, end)) continue;
        if (!in_view(polar(begin)) || !in_view(polar(end))) continue;
        out.lines.push_back({noisy(begin), noisy(end)});
    }
}

void Camera::see(const body::Scene& scene, const body::Player& self, wire::See& out) {
    out = {};
    const auto head = static_cast<std::size_t>(*self.robot->model().body_of(nao::Part::Head));
    const Quat rotation = self.robot->rotation(head);
    const View view{self.robot->position(head), rotation.conjugate().toRotationMatrix(),
                    calibration_};
    see_landmarks(view, out);
    out.ball = look_at(view, scene.ball.position());
    see_players(view, scene, out);
    if (config_.ground_truth) {
        const Vec3 forward = body::flipped(rotation * Vec3::UnitY(), self.team);
        out.my_position = body::flipped(view.origin, self.team);
        out.my_orientation_deg = degrees(std::atan2(forward.y(), forward.x()));
        out.ball_position = body::flipped(scene.ball.position(), self.team);
    }
    see_lines(view, out);
}

bool clip_to_view(Vec3& begin, Vec3& end) {
    static const double slope = std::tan(radians(kViewHalfAngleDeg));
    // Signed distances to the five planes: in front of the image plane, then the four sides.
    const auto sides = [](const Vec3& p) {
        return std::array<double, 5>{p.y() - kMinSeenDistance, slope * p.y() - p.x(),
                                     slope * p.y() + p.x(), slope * p.y() - p.z(),
                                     slope * p.y() + p.z()};
    };
    const std::array<double, 5> at_begin = sides(begin);
    const std::array<double, 5> at_end = sides(end);
    double enter = 0.0;
    double leave = 1.0;
    for (std::size_t k = 0; k < at_begin.size(); ++k) {
        const double b = at_begin[k];
        const double e = at_end[k];
        if (b < 0.0 && e < 0.0) return false;
        if (b < 0.0) enter = std::max(enter, b / (b - e));
        if (e < 0.0) leave = std::min(leave, b / (b - e));
    }
    if (enter > leave) return false;
    const Vec3 whole = end - begin;
    end = begin + leave * whole;
    begin += enter * whole;
    return true;
}

}  // namespace k3d::server::percepts
