// SPDX-License-Identifier: BSD-3-Clause
#include "server/percepts/vision.h"

#include <array>
#include <cmath>
#include <utility>

#include "common/field/field.h"
#include "common/nao/camera.h"

namespace k3d::server::percepts {

namespace {

wire::Pol polar(const Vec3& in_head) {
    return {in_head.norm(), wrap_degrees(degrees(std::atan2(in_head.y(), in_head.x())) - 90.0),
            degrees(std::atan2(in_head.z(), std::hypot(in_head.x(), in_head.y())))};
}

/// Whether both angles are within the view. Squares of coordinates tell it but for points on its border.
bool in_view(const Vec3& in_head) {
    static_assert(kViewHalfAngleDeg == 60.0, "its tangent's square is 3");
    const Vec3 squares = in_head.cwiseAbs2();
    const double beside = squares.x() - 3.0 * squares.y();
    const double above = squares.z() - 3.0 * (squares.x() + squares.y());
    const double border = 1e-9 * squares.sum();
    if (in_head.y() < 0.0 || beside > border || above > border) return false;
    if (beside < -border && above < -border) return true;
    const wire::Pol pol = polar(in_head);
    return std::abs(pol.theta_deg) <= kViewHalfAngleDeg && std::abs(pol.phi_deg) <= kViewHalfAngleDeg;
}

/// Of a line's end, calibration error included.
bool visible(const Vec3& in_head) {
    return in_head.norm() > kMinSeenDistance && in_view(in_head);
}

/// Moves the end that lies behind the image plane onto it; false if both do.
bool cut_at_image_plane(Vec3& begin, Vec3& end) {
    constexpr double kPlane = kMinSeenDistance;
    if (begin.y() < kPlane && end.y() < kPlane) return false;
    if (begin.y() < kPlane) {
        begin = end + (begin - end) * ((kPlane - end.y()) / (begin.y() - end.y()));
    } else if (end.y() < kPlane) {
        end = begin + (end - begin) * ((kPlane - begin.y()) / (end.y() - begin.y()));
    }
    return true;
}

struct Crossings {
    std::array<Vec3, 2> points;
    std::size_t count = 0;
};

/// Where the segment, all before the camera, crosses the sides of the view pyramid: at most two
/// points, in the order top, bottom, left, right.
Crossings crossings(const Vec3& begin, const Vec3& end) {
    struct Side {
        int across;   // the axis on which the side lies ...
        double sign;  // ... in which direction
        int along;    // the axis along which it runs
    };
    constexpr int kX = 0;
    constexpr int kZ = 2;
    constexpr std::array<Side, 4> kSides{
        {{kZ, 1.0, kX}, {kZ, -1.0, kX}, {kX, -1.0, kZ}, {kX, 1.0, kZ}}};
    static const double slope = std::tan(radians(kViewHalfAngleDeg));
    Crossings found;
    for (const Side& side : kSides) {
        const double outside_begin = side.sign * begin[side.across] - slope * begin.y();
        const double outside_end = side.sign * end[side.across] - slope * end.y();
        if ((outside_begin > 0.0) == (outside_end > 0.0)) continue;
        const double share = outside_begin / (outside_begin - outside_end);
        const Vec3 point = begin + share * (end - begin);
        const bool on_edge = std::abs(point[side.along]) <= slope * point.y();
        if (on_edge && found.count < found.points.size()) found.points[found.count++] = point;
    }
    return found;
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
    pol.distance *= 1.0 + noise_.normal(0.0, nao::kSightDistanceNoise);
    pol.theta_deg += noise_.normal(0.0, nao::kSightThetaNoiseDeg);
    pol.phi_deg += noise_.normal(0.0, nao::kSightPhiNoiseDeg);
    return pol;
}

std::optional<wire::Pol> Camera::look_at(const View& view, const Vec3& point) {
    if ((point - view.origin).norm() <= kMinSeenDistance) return std::nullopt;
    const Vec3 in_head = view(point);
    if (!in_view(in_head)) return std::nullopt;
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
        if (clip_to_view(begin, end)) out.lines.push_back({noisy(begin), noisy(end)});
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
    if (config_.my_position) out.my_position = body::flipped(view.origin, self.team);
    if (config_.my_orientation) {
        const Vec3 forward = body::flipped(rotation * Vec3::UnitY(), self.team);
        out.my_orientation_deg = degrees(std::atan2(forward.y(), forward.x()));
    }
    if (config_.ball_position) {
        out.ball_position = body::flipped(scene.ball.position(), self.team);
    }
    see_lines(view, out);
}

bool clip_to_view(Vec3& begin, Vec3& end) {
    const bool sees_begin = visible(begin);
    const bool sees_end = visible(end);
    if (sees_begin && sees_end) return true;
    Vec3 from = begin;
    Vec3 to = end;
    if (!cut_at_image_plane(from, to)) return false;
    const Crossings edges = crossings(from, to);
    if (edges.count == 2) {
        begin = edges.points[0];
        end = edges.points[1];
        return true;
    }
    // One crossing makes one unseen end good; with none, or two unseen ends, the line is lost.
    if (edges.count == 0 || (!sees_begin && !sees_end)) return false;
    (sees_begin ? end : begin) = edges.points[0];
    return true;
}

}  // namespace k3d::server::percepts
