// SPDX-License-Identifier: BSD-3-Clause
#include "server/physics/collision.h"

#include <algorithm>
#include <array>
#include <utility>

namespace k3d::server::physics {

namespace {

constexpr int kMaxContactsPerPair = 4;

constexpr Bounds kNowhere{dInfinity, -dInfinity, dInfinity, -dInfinity, dInfinity, -dInfinity};

bool apart(const Bounds& a, const Bounds& b) {
    return a[0] > b[1] || b[0] > a[1] || a[2] > b[3] || b[2] > a[3] || a[4] > b[5] || b[4] > a[5];
}

const Tag* tag_of(dGeomID geom) {
    return static_cast<const Tag*>(dGeomGetData(geom));
}

dSurfaceParameters surface_parameters(const Tag& a, const Tag& b) {
    const Surface surface = mixed(*a.surface, *b.surface);
    dSurfaceParameters p{};
    p.mu = dInfinity;
    if (surface.bounce) {
        p.mode |= dContactBounce;
        p.bounce = *surface.bounce;
        p.bounce_vel = surface.bounce_velocity.value_or(0.0);
    }
    if (surface.slip) {
        p.mode |= dContactSlip1 | dContactSlip2;
        p.slip1 = p.slip2 = *surface.slip;
    }
    if (surface.soft_erp) {
        p.mode |= dContactSoftERP;
        p.soft_erp = *surface.soft_erp;
    }
    if (surface.soft_cfm) {
        p.mode |= dContactSoftCFM;
        p.soft_cfm = *surface.soft_cfm;
    }
    return p;
}

}  // namespace

Collision::~Collision() {
    for (const Group& group : groups_) {
        for (const Shape& shape : group.shapes) dGeomDestroy(shape.geom);
    }
}

int Collision::add_group() {
    groups_.push_back({.id = next_id_++, .shapes = {}, .bounds = {}});
    return groups_.back().id;
}

void Collision::remove_group(int id) {
    const auto group = find_group(id);
    for (const Shape& shape : group->shapes) dGeomDestroy(shape.geom);
    groups_.erase(group);
}

void Collision::add_geom(int group, dGeomID geom) {
    find_group(group)->shapes.push_back({geom, {}});
}

std::vector<Collision::Group>::iterator Collision::find_group(int id) {
    return std::find_if(groups_.begin(), groups_.end(),
                        [id](const Group& g) { return g.id == id; });
}

const std::vector<Touch>& Collision::find() {
    found_.clear();
    for (Group& group : groups_) group.bound();
    for (std::size_t i = 0; i < groups_.size(); ++i) {
        for (std::size_t j = i + 1; j < groups_.size(); ++j) collide_groups(groups_[i], groups_[j]);
    }
    return found_;
}

void Collision::Group::bound() {
    bounds = kNowhere;
    for (Shape& shape : shapes) {
        dGeomGetAABB(shape.geom, shape.bounds.data());
        for (std::size_t k = 0; k < 6; k += 2) {
            bounds[k] = std::min(bounds[k], shape.bounds[k]);
            bounds[k + 1] = std::max(bounds[k + 1], shape.bounds[k + 1]);
        }
    }
}

void Collision::collide_groups(const Group& one, const Group& other) {
    if (apart(one.bounds, other.bounds)) return;
    for (const Shape& a : one.shapes) {
        if (apart(a.bounds, other.bounds)) continue;
        for (const Shape& b : other.shapes) {
            if (!apart(a.bounds, b.bounds)) collide_pair(a.geom, b.geom);
        }
    }
}

void Collision::collide_pair(dGeomID one, dGeomID other) {
    if (tag_of(one)->kind < tag_of(other)->kind) std::swap(one, other);
    if (dGeomGetBody(one) == nullptr) return;
    std::array<dContactGeom, kMaxContactsPerPair> points;
    const int count = dCollide(one, other, kMaxContactsPerPair, points.data(), sizeof(points[0]));
    if (count == 0) return;
    Touch touch{};
    touch.a = tag_of(one);
    touch.b = tag_of(other);
    touch.body_a = dGeomGetBody(one);
    touch.body_b = dGeomGetBody(other);
    touch.contact.surface = surface_parameters(*touch.a, *touch.b);
    for (int k = 0; k < count; ++k) {
        touch.contact.geom = points[static_cast<std::size_t>(k)];
        found_.push_back(touch);
    }
}

}  // namespace k3d::server::physics
