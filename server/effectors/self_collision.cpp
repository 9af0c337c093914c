// SPDX-License-Identifier: BSD-3-Clause
#include "server/effectors/self_collision.h"

#include <cmath>
#include <utility>
#include <vector>

namespace k3d::server::effectors {

namespace {

using nao::Part;

/// Neighbours that always overlap a little.
constexpr std::array<std::pair<Part, Part>, 8> kForgiven{{{Part::Torso, Part::RThigh},
                                                          {Part::Torso, Part::LThigh},
                                                          {Part::RThigh, Part::RShank},
                                                          {Part::LThigh, Part::LShank},
                                                          {Part::RShank, Part::RFoot},
                                                          {Part::LShank, Part::LFoot},
                                                          {Part::RFoot, Part::RToe},
                                                          {Part::LFoot, Part::LToe}}};

bool forgiven(Part a, Part b) {
    for (const auto& [one, other] : kForgiven) {
        if ((a == one && b == other) || (a == other && b == one)) return true;
    }
    return false;
}

double reach(const Box& box, const Vec3& axis) {
    return box.half.dot((box.axes.transpose() * axis).cwiseAbs());
}

bool separates(const Vec3& axis, const Box& a, const Box& b, double tolerance) {
    const double apart = std::abs((b.centre - a.centre).dot(axis));
    return apart + tolerance > reach(a, axis) + reach(b, axis);
}

}  // namespace

bool overlap(const Box& a, const Box& b, double tolerance) {
    // Most pairs are settled by their distance alone.
    const double touching = a.half.norm() + b.half.norm() - tolerance;
    if (touching <= 0.0 || (b.centre - a.centre).squaredNorm() > touching * touching) return false;
    for (int i = 0; i < 3; ++i) {
        if (separates(a.axes.col(i), a, b, tolerance)) return false;
        if (separates(b.axes.col(i), a, b, tolerance)) return false;
    }
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            if (separates(a.axes.col(i).cross(b.axes.col(j)), a, b, tolerance)) return false;
        }
    }
    return true;
}

std::optional<SelfCollision::Limb> SelfCollision::limb_of(Part part) {
    if (part >= Part::RShoulder && part <= Part::RLowerArm) return RightArm;
    if (part >= Part::LShoulder && part <= Part::LLowerArm) return LeftArm;
    if (part >= Part::RHip1 && part <= Part::RToe) return RightLeg;
    if (part >= Part::LHip1 && part <= Part::LToe) return LeftLeg;
    return std::nullopt;
}

std::optional<SelfCollision::Limb> SelfCollision::limb_of(nao::JointId joint) {
    using nao::JointId;
    if (joint >= JointId::RShoulderPitch && joint <= JointId::RElbow) return RightArm;
    if (joint >= JointId::LShoulderPitch && joint <= JointId::LElbow) return LeftArm;
    if (joint >= JointId::RHipYawPitch && joint <= JointId::RAnkleRoll) return RightLeg;
    if (joint >= JointId::LHipYawPitch && joint <= JointId::LAnkleRoll) return LeftLeg;
    if (joint == JointId::RToe) return RightLeg;
    if (joint == JointId::LToe) return LeftLeg;
    return std::nullopt;
}

bool SelfCollision::judge(const body::Robot& robot, double now) {
    for (State& limb : limbs_) {
        if (limb.since && now - *limb.since >= kFrozenTime) limb.frozen = false;
        if (limb.since && now - *limb.since > kFrozenTime + kImmuneTime) limb.since.reset();
    }
    struct Placed {
        Part part;
        Box box;
    };
    std::vector<Placed> boxes;
    const std::vector<nao::BodyDef>& bodies = robot.model().bodies;
    boxes.reserve(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!bodies[i].collides || bodies[i].shape != nao::Shape::Box) continue;
        boxes.push_back({bodies[i].part,
                         {robot.position(i), robot.rotation(i).toRotationMatrix(),
                          bodies[i].size / 2.0}});
    }
    bool foul = false;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = i + 1; j < boxes.size(); ++j) {
            if (forgiven(boxes[i].part, boxes[j].part) ||
                !overlap(boxes[i].box, boxes[j].box, kOverlapTolerance)) {
                continue;
            }
            for (const Part part : {boxes[i].part, boxes[j].part}) {
                const auto limb = limb_of(part);
                if (!limb || limbs_[*limb].since) continue;
                limbs_[*limb] = {true, now};
                foul = true;
            }
        }
    }
    return foul;
}

bool SelfCollision::frozen(nao::JointId joint) const {
    const auto limb = limb_of(joint);
    return limb && limbs_[*limb].frozen;
}

}  // namespace k3d::server::effectors
