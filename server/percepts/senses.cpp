// SPDX-License-Identifier: BSD-3-Clause
#include "server/percepts/senses.h"

namespace k3d::server::percepts {

void Senses::after_step(const body::Scene& scene, const body::Player& self, double time,
                        wire::Percepts& out) {
    const body::Robot& robot = *self.robot;
    out = {};
    out.time = time;
    out.gyro_deg = gyro_deg(robot);
    out.acceleration = accelerometer_.reading();
    for (const nao::JointDef& joint : robot.model().joints) {
        out.joints_deg[nao::index(joint.id)] = degrees(robot.angle(joint.id));
        out.has_joint.set(nao::index(joint.id));
    }
    forces_.update(robot, scene.world.contacts());
    out.feet = forces_.readings();
    if (cycles_until_see_ == 0) {
        camera_.see(scene, self, out.see.emplace());
        cycles_until_see_ = interval_;
    }
    --cycles_until_see_;
}

}  // namespace k3d::server::percepts
