// SPDX-License-Identifier: BSD-3-Clause
// The one table of the robot: bodies, joints and masses of Nao types 0-4. The server builds its
// bodies from it, the agent its kinematics, the page its drawing.
//
// Frame of every body: x = robot's right, y = forward, z = up; origin at the centre of the part's
// shape, which is also its centre of mass. Metres, kilograms, radians. Source: SimSpark reference 5.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "common/math/geometry.h"

namespace k3d::nao {

inline constexpr int kTypeCount = 5;

/// Joints of all types; arrays indexed by it have kJointCount entries. Toes exist in type 4 only.
enum class JointId : std::uint8_t {
    HeadYaw, HeadPitch,
    RShoulderPitch, RShoulderYaw, RArmRoll, RElbow,
    LShoulderPitch, LShoulderYaw, LArmRoll, LElbow,
    RHipYawPitch, RHipRoll, RHipPitch, RKneePitch, RAnklePitch, RAnkleRoll,
    LHipYawPitch, LHipRoll, LHipPitch, LKneePitch, LAnklePitch, LAnkleRoll,
    RToe, LToe,
};
inline constexpr std::size_t kJointCount = 24;
inline constexpr std::size_t index(JointId id) { return static_cast<std::size_t>(id); }

/// One value per joint, indexed by index(JointId).
using JointArray = std::array<double, kJointCount>;

enum class Part : std::uint8_t {
    Torso, Neck, Head,
    RShoulder, RUpperArm, RElbow, RLowerArm,
    LShoulder, LUpperArm, LElbow, LLowerArm,
    RHip1, RHip2, RThigh, RShank, RAnkle, RFoot, RToe,
    LHip1, LHip2, LThigh, LShank, LAnkle, LFoot, LToe,
};
inline constexpr std::size_t kPartCount = 25;
inline constexpr std::size_t index(Part part) { return static_cast<std::size_t>(part); }

enum class Shape : std::uint8_t { Box, Sphere, Capsule };

struct BodyDef {
    Part part;
    std::string_view name;  ///< node name of the reference ("body", "rupperarm", ...)
    int parent;             ///< index into Model::bodies, -1 for the torso
    Vec3 offset;            ///< centre relative to the parent's centre at zero pose, parent frame
    Shape shape;            ///< of the mass and, if collides, of the collider
    Vec3 size;              ///< box: full extents; sphere: (r, r, r); capsule along z: (r, length, 0)
    double mass;
    bool collides;
};

struct JointDef {
    JointId id;
    std::string_view perceptor;  ///< "rlj3"
    std::string_view effector;   ///< "rle3"
    int child;                   ///< index into Model::bodies; the parent is that body's parent
    Vec3 axis;                   ///< unit vector in the child frame; positive = right-hand rule on the child
    Vec3 anchor;                 ///< hinge point in the child frame
    double min, max;             ///< rad
    double max_rate;             ///< rad/s
};

/// Constants of one type. Joint k moves body k + 1; bodies and joints stand in the order of the
/// percept frame (reference 3.2): head, right arm, left arm, right leg, left leg.
struct Model {
    int type;
    std::vector<BodyDef> bodies;
    std::vector<JointDef> joints;
    double total_mass;
    double standing_height;  ///< torso centre above the sole at zero pose
    double hip_offset_x;     ///< hip's distance from the torso's middle plane
    double hip_offset_y;     ///< hip axis relative to the torso centre (negative: behind)
    double hip_offset_z;
    double thigh_length;     ///< hip axis to knee axis
    double shank_length;     ///< knee axis to ankle axis
    double ankle_height;     ///< ankle pitch axis above the sole

    std::optional<int> body_of(Part part) const;  ///< index into bodies, none if the type lacks it
};

/// The table of a type, 0..4. Aborts on another number: check input with is_type() first.
const Model& model(int type);
inline bool is_type(int type) { return type >= 0 && type < kTypeCount; }

/// Joint with this effector name ("rle3") or perceptor name ("rlj3"), of any type.
std::optional<JointId> joint_by_effector(std::string_view name);
std::optional<JointId> joint_by_perceptor(std::string_view name);
std::string_view effector_name(JointId id);
std::string_view perceptor_name(JointId id);

inline constexpr double kMaxTorque = 10.0;   // N m, every hinge motor (reference 5.2)
inline constexpr double kMaxRate = 6.1395;   // rad/s, all joints but type 2's ankles

}  // namespace k3d::nao
