// SPDX-License-Identifier: BSD-3-Clause
// What decision asks of the body and what the body tells back. motion/ turns a request into joint
// rates, one cycle at a time; it owns balance, falls and getting up.
//
// Frame of requests: the robot's own, x forward, y left, z up, origin on the ground below the
// torso centre, x along the torso's heading. Metres, radians, seconds.
#pragma once

#include <optional>
#include <variant>

#include "common/math/geometry.h"
#include "common/nao/model.h"

namespace k3d::agent::motion {

/// Contact force on a sole, in the foot's frame (agent axes: x forward, y left, z up).
struct SoleForce {
    Vec3 point = Vec3::Zero();
    Vec3 force = Vec3::Zero();
};

/// What the body senses in one cycle, converted from the wire to agent axes and SI units.
struct BodySense {
    double time = 0.0;                    ///< `now`, s
    nao::JointArray joints{};             ///< rad, in the table's own sign convention
    Vec3 gyro = Vec3::Zero();             ///< rad/s about x forward, y left, z up
    Vec3 acceleration = Vec3::Zero();     ///< m/s^2, (0, 0, 9.81) at rest
    std::optional<SoleForce> right_sole;  ///< absent without contact
    std::optional<SoleForce> left_sole;
};

/// Stand still, knees bent, ready to walk.
struct Stand {};

/// Walk with this velocity; limits and acceleration are the walk engine's business.
struct Walk {
    double forward = 0.0;  ///< m/s
    double left = 0.0;     ///< m/s
    double turn = 0.0;     ///< rad/s, counter-clockwise
    bool brisk = false;    ///< walk and turn harder at the same time, at the risk of a fall
};

/// Kick the ball from where the robot stands. Decision asks for it only when kick_possible() of
/// the kick engine says that the ball lies in reach; it is asked again each cycle until the kick
/// is done, and once the swing has begun the engine finishes it whatever is asked.
struct Kick {
    Vec2 ball = Vec2::Zero();   ///< robot frame
    double direction = 0.0;     ///< rad, robot frame: where the ball shall go, 0 = straight ahead
    double distance = 5.0;      ///< m wanted
    bool hurried = false;       ///< begin sooner after the last step, at the risk of a fall
};

/// Tip over on purpose, for drills of falling and getting up: the ankles turn at these speeds until
/// the robot falls.
struct Topple {
    double forward = 0.0;  ///< rad/s, negative: onto the back
    double left = 0.0;     ///< rad/s
};

using BodyRequest = std::variant<Stand, Walk, Kick, Topple>;

/// Where the head shall look: neck yaw (positive left) and pitch (positive up), rad.
struct HeadRequest {
    double yaw = 0.0;
    double pitch = -0.35;
};

struct Request {
    BodyRequest body = Stand{};
    HeadRequest head;
};

enum class Activity { Standing, Walking, Kicking, Falling, GettingUp };

/// What motion knows about the body after a cycle.
struct State {
    Activity activity = Activity::Standing;
    bool upright = true;          ///< false from the moment a fall is certain until up again
    bool kick_started = false;    ///< true in exactly the cycle in which a kick motion begins
    bool kick_done = false;       ///< true in exactly the cycle in which it ends
    int falls = 0;                ///< since the start
    Pose2 odometry;               ///< motion since the cycle before, in the frame of that cycle
    Quat torso = Quat::Identity();   ///< torso axes -> level robot frame (roll and pitch, no yaw)
    double torso_height = 0.0;       ///< m above the ground, from kinematics over the lower sole
    Vec3 camera = Vec3::Zero();      ///< camera (head centre) in the robot frame
    Quat camera_rotation = Quat::Identity();  ///< camera axes (x forward, y left, z up) -> robot frame
};

}  // namespace k3d::agent::motion
