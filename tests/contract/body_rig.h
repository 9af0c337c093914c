// SPDX-License-Identifier: BSD-3-Clause
// One robot in the server's physics, driven in one process with the latency and the rounding of the
// wire: for tests of motion, and for tuning it.
//
// Frame: field frame, metres, radians, seconds. The state after step n is sensed with two decimals
// (degrees, m/s^2, N) and the reply to it drives step n + 2 (reference 2.1, 3).
#pragma once

#include <optional>

#include "agent/motion/motion.h"
#include "server/body/arena.h"
#include "server/body/ball.h"
#include "server/body/robot.h"

namespace k3d::contract {

class BodyRig {
  public:
    /// The robot stands upright with straight legs, soles on the ground, at `start`.
    explicit BodyRig(int type = 0, const Pose2& start = {},
                     server::physics::Stepper stepper = server::physics::Stepper::Exact);

    /// What the agent senses after the last step.
    const agent::motion::BodySense& sense() const { return sense_; }
    /// The agent's reply to sense(): runs one step under the reply before, then senses.
    void advance(const nao::JointArray& rates);

    const nao::Model& model() const { return robot_.model(); }
    server::physics::World& world() { return world_; }
    server::body::Robot& robot() { return robot_; }
    server::body::Ball& ball() { return ball_; }  ///< starts at rest, out of the way
    double time() const { return sense_.time; }

    // Truth.
    Pose2 pose() const;     ///< torso on the ground, with its heading
    double height() const;  ///< of the torso centre
    double tilt() const;    ///< angle of the torso's up axis against the vertical, rad
    bool fallen() const { return tilt() > radians(60.0); }

  private:
    void feel();
    std::optional<agent::motion::SoleForce> sole(nao::Part foot) const;

    server::physics::World world_;
    server::body::Arena arena_;
    server::body::Ball ball_;
    server::body::Robot robot_;
    agent::motion::BodySense sense_;
    nao::JointArray pending_{};
    Vec3 velocity_ = Vec3::Zero();         ///< before the last step
    Vec3 velocity_before_ = Vec3::Zero();  ///< before the step before that
    int steps_ = 0;
};

}  // namespace k3d::contract
