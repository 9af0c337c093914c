// SPDX-License-Identifier: BSD-3-Clause
#include "agent/perception/view.h"

#include <array>

#include "agent/perception/level.h"

namespace k3d::agent::perception {

namespace {

constexpr double kFallenHeadHeight = 0.25;  // m above the feet: upright 0.47, lying about 0
constexpr std::size_t kMaxGround = 64;      // line ends used for levelling; a See has at most 42
constexpr double kMinLineLength = 0.05;     // m: shorter pieces have no direction to speak of

bool finite(const wire::Pol& pol) {
    return std::isfinite(pol.distance) && std::isfinite(pol.theta_deg) &&
           std::isfinite(pol.phi_deg) && pol.distance >= 0.0;
}

/// Camera frame -> robot frame, z above the ground.
struct Camera {
    Vec3 position;
    Quat rotation;

    Vec3 point(const wire::Pol& pol) const { return position + rotation * to_camera(pol); }
};

/// The camera as the body believes it to stand, turned with the torso until the lines lie level.
Camera levelled(const wire::See& see, const motion::State& body) {
    std::array<Vec3, kMaxGround> ground;
    std::size_t count = 0;
    for (const wire::SeenLine& line : see.lines) {
        for (const wire::Pol& end : {line.begin, line.end}) {
            if (count < kMaxGround && finite(end)) {
                ground[count++] = body.camera_rotation * to_camera(end);
            }
        }
    }
    const Quat correction = level({ground.data(), count}, body.camera.z());
    const Vec3 torso(0.0, 0.0, body.torso_height);
    return {torso + correction * (body.camera - torso), correction * body.camera_rotation};
}

/// The mean of those of `parts` that were seen.
std::optional<Vec3> middle(const Camera& camera,
                           std::initializer_list<const std::optional<wire::Pol>*> parts) {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (const auto* part : parts) {
        if (!*part || !finite(**part)) continue;
        sum += camera.point(**part);
        ++count;
    }
    if (count == 0) return std::nullopt;
    return Vec3(sum / count);
}

std::optional<PlayerSight> player(const wire::SeenPlayer& seen, const Camera& camera,
                                  const Identity& self) {
    const bool mate = seen.team == self.team;
    if (mate && (self.unum == 0 || seen.unum == self.unum)) return std::nullopt;
    const auto head = middle(camera, {&seen.head});
    const auto feet = middle(camera, {&seen.rfoot, &seen.lfoot});
    const auto arms = middle(camera, {&seen.rlowerarm, &seen.llowerarm});
    PlayerSight sight{mate, seen.unum, Vec2::Zero(), std::nullopt};
    if (head) sight.fallen = head->z() - (feet ? feet->z() : 0.0) < kFallenHeadHeight;
    if (head && feet) {
        sight.position = 0.5 * (*head + *feet).head<2>();
    } else if (head || feet || arms) {
        sight.position = (head ? *head : feet ? *feet : *arms).head<2>();
    } else {
        return std::nullopt;
    }
    return sight;
}

}  // namespace

Vec3 to_camera(const wire::Pol& pol) {
    const double theta = radians(pol.theta_deg);
    const double phi = radians(pol.phi_deg);
    const double level = pol.distance * std::cos(phi);
    return {level * std::cos(theta), level * std::sin(theta), pol.distance * std::sin(phi)};
}

void look(const wire::See& see, const motion::State& body, const Identity& self, View& view) {
    const Camera camera = levelled(see, body);
    view.camera = camera.position;
    view.camera_rotation = camera.rotation;
    view.landmarks.clear();
    view.landmarks.reserve(see.landmarks.size());
    for (std::size_t k = 0; k < see.landmarks.size(); ++k) {
        const auto& pol = see.landmarks[k];
        if (!pol || !finite(*pol)) continue;
        view.landmarks.push_back({static_cast<field::Landmark>(k), camera.point(*pol).head<2>()});
    }
    view.lines.clear();
    view.lines.reserve(kMaxGround);
    for (const wire::SeenLine& line : see.lines) {
        if (!finite(line.begin) || !finite(line.end)) continue;
        const Vec2 begin = camera.point(line.begin).head<2>();
        const Vec2 end = camera.point(line.end).head<2>();
        const double length = (end - begin).norm();
        if (length >= kMinLineLength) view.lines.push_back({begin, end, length});
    }
    view.ball.reset();
    if (see.ball && finite(*see.ball)) view.ball = camera.point(*see.ball);
    view.players.clear();
    view.players.reserve(22);
    for (const wire::SeenPlayer& seen : see.players) {
        if (const auto sight = player(seen, camera, self)) view.players.push_back(*sight);
    }
}

}  // namespace k3d::agent::perception
