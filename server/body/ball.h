// SPDX-License-Identifier: BSD-3-Clause
// The ball (reference 6.5). Field frame, m, m/s.
#pragma once

#include "server/physics/world.h"

namespace k3d::server::body {

class Ball {
  public:
    explicit Ball(physics::World& world);
    ~Ball();
    Ball(const Ball&) = delete;
    Ball& operator=(const Ball&) = delete;

    Vec3 position() const;
    Quat rotation() const;
    Vec3 velocity() const;

    void move(const Vec3& position);          ///< keeps the velocity; wakes the ball
    void set_velocity(const Vec3& velocity);  ///< zeroes the spin; wakes the ball

  private:
    physics::World& world_;
    physics::Tag tag_{&physics::kBallSurface, physics::Kind::Ball, 0, nao::Part::Torso};
    int group_;
    dxBody* body_;
};

}  // namespace k3d::server::body
