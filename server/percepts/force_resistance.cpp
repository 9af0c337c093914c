// SPDX-License-Identifier: BSD-3-Clause
#include "server/percepts/force_resistance.h"

namespace k3d::server::percepts {

namespace {

constexpr std::array<nao::Part, wire::kFootSensorCount> kParts{
    nao::Part::RFoot, nao::Part::LFoot, nao::Part::RToe, nao::Part::LToe};

/// Contacts of one sole, summed up.
struct Sum {
    bool touched = false;
    Vec3 force = Vec3::Zero();
    Vec3 weighted = Vec3::Zero();  // points weighted by the size of their force
    double weight = 0.0;

    void add(const Vec3& point, const Vec3& on_foot) {
        const double size = on_foot.norm();
        touched = true;
        force += on_foot;
        weighted += size * point;
        weight += size;
    }
};

}  // namespace

void ForceSensors::update(const body::Robot& robot, std::span<const physics::Contact> contacts) {
    std::array<Sum, wire::kFootSensorCount> sums;
    for (const physics::Contact& contact : contacts) {
        for (std::size_t k = 0; k < kParts.size(); ++k) {
            const auto is_mine = [&](const physics::Tag& tag) {
                return tag.kind == physics::Kind::Robot && tag.owner == robot.owner() &&
                       tag.part == kParts[k];
            };
            if (is_mine(*contact.a)) sums[k].add(contact.point, contact.force_on_a);
            if (is_mine(*contact.b)) sums[k].add(contact.point, -contact.force_on_a);
        }
    }
    for (std::size_t k = 0; k < kParts.size(); ++k) {
        readings_[k].reset();
        if (!sums[k].touched) continue;
        if (sums[k].weight > 0.0) {
            const auto body = static_cast<std::size_t>(*robot.model().body_of(kParts[k]));
            const Quat to_foot = robot.rotation(body).conjugate();
            last_[k] = {to_foot * (sums[k].weighted / sums[k].weight - robot.position(body)),
                        to_foot * sums[k].force};
        }
        readings_[k] = last_[k];
    }
}

}  // namespace k3d::server::percepts
