// SPDX-License-Identifier: BSD-3-Clause
#include "server/physics/fast/fast_stepper.h"

#include <algorithm>

#include "common/clock/clock.h"

namespace k3d::server::physics::fast {

namespace {

Settings settings_of(dWorldID world) {
    dVector3 gravity;
    dWorldGetGravity(world, gravity);
    return {{gravity[0], gravity[1], gravity[2]},
            dWorldGetERP(world),
            dWorldGetCFM(world),
            dWorldGetContactSurfaceLayer(world)};
}

}  // namespace

FastStepper::FastStepper(dWorldID world) : settings_(settings_of(world)) {}

void FastStepper::add(const Mechanism& mechanism) {
    linkages_.push_back(std::make_unique<Linkage>(mechanism, settings_));
}

void FastStepper::remove(const dxBody* first) {
    std::erase_if(linkages_, [first](const auto& l) { return l->first_body() == first; });
}

void FastStepper::step(const std::vector<Touch>& touches, std::vector<Contact>& contacts) {
    for (const auto& linkage : linkages_) linkage->read();
    grips_.clear();
    for (const Touch& touch : touches) grips_.push_back(make_grip(touch, settings_));
    label_islands();
    for (std::size_t label = 0; label < linkages_.size(); ++label) solve_island(label);
    for (const auto& linkage : linkages_) linkage->write();
    contacts.clear();
    for (std::size_t i = 0; i < touches.size(); ++i) {
        contacts.push_back(
            {touches[i].a, touches[i].b, grips_[i].point, grips_[i].impulse / kCycleSeconds});
    }
}

/// Gives linkages that contacts join, directly or over others, the lowest number among them.
void FastStepper::label_islands() {
    for (std::size_t i = 0; i < linkages_.size(); ++i) linkages_[i]->island = i;
    for (bool changed = true; changed;) {
        changed = false;
        for (const Grip& grip : grips_) {
            if (grip.b.linkage == nullptr || grip.a.linkage->island == grip.b.linkage->island)
                continue;
            const std::size_t low = std::min(grip.a.linkage->island, grip.b.linkage->island);
            grip.a.linkage->island = grip.b.linkage->island = low;
            changed = true;
        }
    }
}

void FastStepper::solve_island(std::size_t label) {
    members_.clear();
    holds_.clear();
    for (const auto& linkage : linkages_) {
        if (linkage->island == label) members_.push_back(linkage.get());
    }
    if (members_.empty()) return;
    for (Grip& grip : grips_) {
        if (grip.a.linkage->island == label) holds_.push_back(&grip);
    }
    solver_.solve(members_, holds_);
}

}  // namespace k3d::server::physics::fast
