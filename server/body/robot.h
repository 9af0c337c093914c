// SPDX-License-Identifier: BSD-3-Clause
// A Nao in the ODE world, built from the table in common/nao (reference 5).
//
// Frame: field frame for positions and velocities; a body's own axes are x right, y forward, z up.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <vector>

#include "server/physics/world.h"

struct dxJoint;

namespace k3d::server::body {

class Robot {
  public:
    /// Upright at `torso`, all joints 0, forward axis along world +y. `owner` tags its contacts.
    Robot(physics::World& world, const nao::Model& model, int owner, const Vec3& torso);
    ~Robot();
    Robot(const Robot&) = delete;
    Robot& operator=(const Robot&) = delete;

    const nao::Model& model() const { return model_; }
    int owner() const { return owner_; }

    /// Sets a hinge's motor under the joint rules of reference 4: clamped to the joint's top
    /// speed, ignored while the angle is outside its stops, a non-zero rate wakes the body.
    void drive(nao::JointId joint, double rate);

    double angle(nao::JointId joint) const;  ///< rad; 0 for a joint this type lacks

    /// By index into model().bodies.
    Vec3 position(std::size_t body) const;
    Quat rotation(std::size_t body) const;

    Vec3 torso_position() const { return position(0); }
    Quat torso_rotation() const { return rotation(0); }
    Vec3 torso_velocity() const;
    Vec3 torso_angular_velocity() const;
    /// Direction of the torso's forward axis on the ground, 0 = world +x.
    double heading() const;

    /// Moves the torso there and everything rigidly with it; orientation and joints stay,
    /// velocities become zero (trainer `pos`).
    void move(const Vec3& torso);
    /// The same, with the torso made upright and looking to `heading` (beam, trainer `move`).
    void place(const Vec3& torso, double heading);

  private:
    void add_body(const nao::BodyDef& def, const Vec3& position);
    void add_joint(const nao::JointDef& def);
    void transform(const Vec3& torso, const Quat& turn);
    double measured(std::size_t joint) const;

    physics::World& world_;
    const nao::Model& model_;
    int owner_;
    int group_;
    std::vector<dxBody*> bodies_;
    std::array<dxJoint*, nao::kJointCount> joints_{};
    std::array<const nao::JointDef*, nao::kJointCount> defs_{};
    std::vector<physics::Tag> tags_;

    /// Angles are asked for once by the percept and once by the reply to it; ODE takes arcs for each.
    mutable nao::JointArray angles_{};
    mutable std::bitset<nao::kJointCount> angle_known_;
    mutable std::uint64_t angles_of_ = 0;  ///< world_.revision()
};

}  // namespace k3d::server::body
