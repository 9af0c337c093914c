// SPDX-License-Identifier: BSD-3-Clause
#include "server/physics/fast/grip.h"

#include <algorithm>

#include "common/clock/clock.h"

namespace k3d::server::physics::fast {

namespace {

constexpr double h = kCycleSeconds;

Side side_of(dBodyID body, const Vec3& point) {
    if (body == nullptr) return {};
    const Place& place = *static_cast<const Place*>(dBodyGetData(body));
    return {place.linkage, place.link, place.linkage->offset_of(place.link, point)};
}

}  // namespace

Vec3 Grip::relative(Vec3 (Linkage::*velocity)(std::size_t, const Vec3&) const) const {
    Vec3 v = (a.linkage->*velocity)(a.link, point);
    if (b.linkage != nullptr) v -= (b.linkage->*velocity)(b.link, point);
    return v;
}

Grip make_grip(const Touch& touch, const Settings& settings) {
    const dContactGeom& geom = touch.contact.geom;
    const dSurfaceParameters& surface = touch.contact.surface;
    Grip grip{};
    grip.point = {geom.pos[0], geom.pos[1], geom.pos[2]};
    grip.a = side_of(touch.body_a, grip.point);
    grip.b = side_of(touch.body_b, grip.point);
    dVector3 first, second;
    dPlaneSpace(geom.normal, first, second);
    grip.directions = {Vec3(geom.normal[0], geom.normal[1], geom.normal[2]),
                       Vec3(first[0], first[1], first[2]), Vec3(second[0], second[1], second[2])};

    const auto stiffness = [&](int mode, double cfm) {
        return h / ((surface.mode & mode) != 0 ? cfm : settings.cfm);
    };
    grip.stiffness = {stiffness(dContactSoftCFM, surface.soft_cfm),
                      stiffness(dContactSlip1, surface.slip1),
                      stiffness(dContactSlip2, surface.slip2)};
    const bool soft = (surface.mode & dContactSoftERP) != 0;
    const double erp = soft ? surface.soft_erp : settings.erp;
    grip.target = erp / h * std::max(geom.depth - settings.surface_layer, 0.0);
    const double incoming = -grip.directions[0].dot(grip.relative(&Linkage::old_velocity));
    if ((surface.mode & dContactBounce) != 0 && incoming > surface.bounce_vel) {
        grip.target = std::max(grip.target, surface.bounce * incoming);
    }
    const double falling = -h * grip.directions[0].dot(settings.gravity);
    grip.pushes = grip.target + incoming + falling > 0.0;
    return grip;
}

}  // namespace k3d::server::physics::fast
