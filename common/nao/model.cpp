// SPDX-License-Identifier: BSD-3-Clause
#include "common/nao/model.h"

#include "common/log/log.h"

namespace k3d::nao {

namespace {

/// What differs between types (reference 5.4).
struct TypeParameters {
    double hip_x;
    double thigh_z;  ///< thigh centre relative to hip 2
    double ankle_z;  ///< ankle relative to shank
    double elbow_y;  ///< elbow relative to upper arm
    double ankle_pitch_rate, ankle_roll_rate;
    bool toes;
};

constexpr std::array<TypeParameters, kTypeCount> kTypes{{
    {0.055, -0.04, -0.055, 0.07, kMaxRate, kMaxRate, false},
    {0.055, -0.05832, -0.07332, 0.10664, kMaxRate, kMaxRate, false},
    {0.055, -0.04, -0.055, 0.07, 8.80667, 3.47234, false},
    {0.072954143, -0.067868424, -0.082868424, 0.125736848, kMaxRate, kMaxRate, false},
    {0.055, -0.04, -0.055, 0.07, kMaxRate, kMaxRate, true},
}};

constexpr double kHipY = -0.01;
constexpr double kHipZ = -0.115;

struct JointName {
    std::string_view perceptor, effector;
};
constexpr std::array<JointName, kJointCount> kJointNames{{
    {"hj1", "he1"},     {"hj2", "he2"},     {"raj1", "rae1"},   {"raj2", "rae2"},
    {"raj3", "rae3"},   {"raj4", "rae4"},   {"laj1", "lae1"},   {"laj2", "lae2"},
    {"laj3", "lae3"},   {"laj4", "lae4"},   {"rlj1", "rle1"},   {"rlj2", "rle2"},
    {"rlj3", "rle3"},   {"rlj4", "rle4"},   {"rlj5", "rle5"},   {"rlj6", "rle6"},
    {"llj1", "lle1"},   {"llj2", "lle2"},   {"llj3", "lle3"},   {"llj4", "lle4"},
    {"llj5", "lle5"},   {"llj6", "lle6"},   {"rlj7", "rle7"},   {"llj7", "lle7"},
}};

/// Adds bodies and the joint above each, parents first.
class Builder {
  public:
    explicit Builder(Model& model) : model_(model) {}

    int body(Part part, std::string_view name, int parent, Vec3 offset, Shape shape, Vec3 size,
             double mass, bool collides) {
        model_.bodies.push_back({part, name, parent, offset, shape, size, mass, collides});
        model_.total_mass += mass;
        return static_cast<int>(model_.bodies.size()) - 1;
    }

    void joint(JointId id, int child, Vec3 axis, Vec3 anchor, double min_deg, double max_deg,
               double max_rate = kMaxRate) {
        const JointName& name = kJointNames[index(id)];
        model_.joints.push_back({id, name.perceptor, name.effector, child, axis.normalized(),
                                 anchor, radians(min_deg), radians(max_deg), max_rate});
    }

  private:
    Model& model_;
};

const Vec3 kPoint(0.01, 0.01, 0.01);  // shape of the massive points between two joints

void add_head(Builder& add, int torso) {
    const int neck = add.body(Part::Neck, "neck", torso, {0, 0, 0.09}, Shape::Capsule,
                              {0.015, 0.08, 0}, 0.05, true);
    add.joint(JointId::HeadYaw, neck, {0, 0, 1}, {0, 0, 0}, -120, 120);
    const int head = add.body(Part::Head, "head", neck, {0, 0, 0.065}, Shape::Sphere,
                              {0.065, 0.065, 0.065}, 0.35, true);
    add.joint(JointId::HeadPitch, head, {1, 0, 0}, {0, 0, -0.005}, -45, 45);
}

void add_arm(Builder& add, int torso, bool right, const TypeParameters& type) {
    // s mirrors x; the ranges of the two vertical axes mirror with it.
    const double s = right ? 1.0 : -1.0;
    const auto pick = [right](JointId r, JointId l) { return right ? r : l; };
    const int shoulder =
        add.body(right ? Part::RShoulder : Part::LShoulder, right ? "rshoulder" : "lshoulder",
                 torso, {s * 0.098, 0, 0.075}, Shape::Sphere, kPoint, 0.07, false);
    add.joint(pick(JointId::RShoulderPitch, JointId::LShoulderPitch), shoulder, {1, 0, 0},
              {0, 0, 0}, -120, 120);
    const int upper =
        add.body(right ? Part::RUpperArm : Part::LUpperArm, right ? "rupperarm" : "lupperarm",
                 shoulder, {s * 0.01, 0.02, 0}, Shape::Box, {0.07, 0.08, 0.06}, 0.15, true);
    add.joint(pick(JointId::RShoulderYaw, JointId::LShoulderYaw), upper, {0, 0, 1},
              {-s * 0.01, -0.02, 0}, right ? -95 : -1, right ? 1 : 95);
    const int elbow =
        add.body(right ? Part::RElbow : Part::LElbow, right ? "relbow" : "lelbow", upper,
                 {-s * 0.01, type.elbow_y, 0.009}, Shape::Sphere, kPoint, 0.035, false);
    add.joint(pick(JointId::RArmRoll, JointId::LArmRoll), elbow, {0, 1, 0}, {0, 0, 0}, -120, 120);
    const int lower =
        add.body(right ? Part::RLowerArm : Part::LLowerArm, right ? "rlowerarm" : "llowerarm",
                 elbow, {0, 0.05, 0}, Shape::Box, {0.05, 0.11, 0.05}, 0.2, true);
    add.joint(pick(JointId::RElbow, JointId::LElbow), lower, {0, 0, 1}, {0, -0.05, 0},
              right ? -1 : -90, right ? 90 : 1);
}

void add_leg(Builder& add, int torso, bool right, const TypeParameters& type) {
    const double s = right ? 1.0 : -1.0;
    const auto pick = [right](JointId r, JointId l) { return right ? r : l; };
    const int hip1 =
        add.body(right ? Part::RHip1 : Part::LHip1, right ? "rhip1" : "lhip1", torso,
                 {s * type.hip_x, kHipY, kHipZ}, Shape::Sphere, kPoint, 0.09, false);
    add.joint(pick(JointId::RHipYawPitch, JointId::LHipYawPitch), hip1, {-0.7071, 0, s * 0.7071},
              {0, 0, 0}, -90, 1);
    const int hip2 = add.body(right ? Part::RHip2 : Part::LHip2, right ? "rhip2" : "lhip2", hip1,
                              {0, 0, 0}, Shape::Sphere, kPoint, 0.125, false);
    add.joint(pick(JointId::RHipRoll, JointId::LHipRoll), hip2, {0, 1, 0}, {0, 0, 0},
              right ? -45 : -25, right ? 25 : 45);
    const int thigh =
        add.body(right ? Part::RThigh : Part::LThigh, right ? "rthigh" : "lthigh", hip2,
                 {0, 0.01, type.thigh_z}, Shape::Box, {0.07, 0.07, 0.14}, 0.275, true);
    add.joint(pick(JointId::RHipPitch, JointId::LHipPitch), thigh, {1, 0, 0},
              {0, -0.01, -type.thigh_z}, -25, 100);
    const int shank =
        add.body(right ? Part::RShank : Part::LShank, right ? "rshank" : "lshank", thigh,
                 {0, 0.005, -0.125}, Shape::Box, {0.08, 0.07, 0.11}, 0.225, true);
    add.joint(pick(JointId::RKneePitch, JointId::LKneePitch), shank, {1, 0, 0},
              {0, -0.01, 0.045}, -130, 1);
    const int ankle =
        add.body(right ? Part::RAnkle : Part::LAnkle, right ? "rankle" : "lankle", shank,
                 {0, -0.01, type.ankle_z}, Shape::Sphere, kPoint, 0.125, false);
    add.joint(pick(JointId::RAnklePitch, JointId::LAnklePitch), ankle, {1, 0, 0}, {0, 0, 0}, -45,
              75, type.ankle_pitch_rate);
    const double foot_y = type.toes ? 0.012241172 : 0.03;
    const Vec3 foot_size(0.08, type.toes ? 0.124482344 : 0.16, 0.02);
    const int foot = add.body(right ? Part::RFoot : Part::LFoot, right ? "rfoot" : "lfoot", ankle,
                              {0, foot_y, -0.04}, Shape::Box, foot_size,
                              type.toes ? 0.177801465 : 0.2, true);
    add.joint(pick(JointId::RAnkleRoll, JointId::LAnkleRoll), foot, {0, 1, 0}, {0, -0.03, 0.035},
              right ? -25 : -45, right ? 45 : 25, type.ankle_roll_rate);
    if (type.toes) {
        const int toe = add.body(right ? Part::RToe : Part::LToe, right ? "rtoe" : "ltoe", foot,
                                 {0, 0.08, -0.005}, Shape::Box, {0.08, 0.035517656, 0.01},
                                 0.022198535, true);
        add.joint(pick(JointId::RToe, JointId::LToe), toe, {1, 0, 0}, {0, -0.017758828, -0.005},
                  -1, 70);
    }
}

Model make_model(int type_index) {
    const TypeParameters& type = kTypes[static_cast<std::size_t>(type_index)];
    Model m{};
    m.type = type_index;
    Builder add(m);
    const int torso = add.body(Part::Torso, "body", -1, {0, 0, 0}, Shape::Box, {0.1, 0.1, 0.18},
                               1.2171, true);
    add_head(add, torso);
    add_arm(add, torso, true, type);
    add_arm(add, torso, false, type);
    add_leg(add, torso, true, type);
    add_leg(add, torso, false, type);
    m.hip_offset_x = type.hip_x;
    m.hip_offset_y = kHipY;
    m.hip_offset_z = kHipZ;
    m.thigh_length = 0.08 - type.thigh_z;
    m.shank_length = 0.045 - type.ankle_z;
    m.ankle_height = 0.05;
    m.standing_height = -kHipZ + m.thigh_length + m.shank_length + m.ankle_height;
    return m;
}

}  // namespace

std::optional<int> Model::body_of(Part part) const {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].part == part) return static_cast<int>(i);
    }
    return std::nullopt;
}

const Model& model(int type) {
    static const std::array<Model, kTypeCount> all{make_model(0), make_model(1), make_model(2),
                                                   make_model(3), make_model(4)};
    K3D_ASSERT(is_type(type));
    return all[static_cast<std::size_t>(type)];
}

std::optional<JointId> joint_by_effector(std::string_view name) {
    for (std::size_t i = 0; i < kJointCount; ++i) {
        if (kJointNames[i].effector == name) return static_cast<JointId>(i);
    }
    return std::nullopt;
}

std::optional<JointId> joint_by_perceptor(std::string_view name) {
    for (std::size_t i = 0; i < kJointCount; ++i) {
        if (kJointNames[i].perceptor == name) return static_cast<JointId>(i);
    }
    return std::nullopt;
}

std::string_view effector_name(JointId id) { return kJointNames[index(id)].effector; }
std::string_view perceptor_name(JointId id) { return kJointNames[index(id)].perceptor; }

}  // namespace k3d::nao
