// SPDX-License-Identifier: BSD-3-Clause
// One pass over the table, parents first.
#include "agent/kinematics/forward.h"

namespace k3d::agent::kinematics {

PartPoses forward(const nao::Model& model, const nao::JointArray& joints) {
    PartPoses parts;
    // Joint k moves body k + 1, and bodies stand in the table parents first.
    for (const nao::JointDef& joint : model.joints) {
        const nao::BodyDef& body = model.bodies[static_cast<std::size_t>(joint.child)];
        const nao::BodyDef& parent = model.bodies[static_cast<std::size_t>(body.parent)];
        const PartPose& above = parts[nao::index(parent.part)];
        const Vec3 anchor = body_to_agent(joint.anchor);
        const Eigen::AngleAxisd turn(joints[nao::index(joint.id)], body_to_agent(joint.axis));
        PartPose& pose = parts[nao::index(body.part)];
        pose.rotation = above.rotation * turn.toRotationMatrix();
        pose.position = above * (body_to_agent(body.offset) + anchor) - pose.rotation * anchor;
    }
    return parts;
}

}  // namespace k3d::agent::kinematics
